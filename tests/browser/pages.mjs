// The pages that the tests look at. A new page is a line here; every_page.test.mjs then holds it to
// what is asked of all.
import { join } from "node:path";
import { hostileCatalog, hostileData } from "./hostile.mjs";
import { executable, sampleExecutable, sources, written } from "./places.mjs";

const inputs = join(written, "inputs");
const golden = (name) => join(sources, "tests/golden", `diagnose_${name}.csv`);

const hand = join(sources, "catalog/hardware/three_finger_hand.toml");

export const theSeven = join(sources, "catalog/measured/exo_glove_ii.csv");

const hostileNames = () => ({ REEVE_CATALOG: hostileCatalog(join(inputs, "catalogue")) });

const reeve = (name, words, more = {}) => ({
  name,
  command: (folder) => [executable, ...words(), "--out", folder],
  ...more,
});

// `command` is given the folder to write to. What is `scripted` has a script of its own, which sets
// data-ready on the root when it is done.
export const pages = [
  { name: "sample", command: (folder) => [sampleExecutable, folder] },
  reeve("explore-2", () => ["explore", "--fingers", "2", "--parts", "full", "--uncertainty"], { scripted: true }),
  reeve("explore-3", () => ["explore", "--fingers", "3", "--parts", "full", "--uncertainty"], { scripted: true }),
  // Of some designs no motor force is enough.
  reeve(
    "explore-hand",
    () => [
      "explore", "--fingers", "3", "--parts", "full", "--objectives", "uniformity,efficiency,motor_force",
      "--hardware", join(sources, "catalog/hardware/three_finger_hand.toml"),
    ],
    { scripted: true },
  ),
  reeve("explore-hostile", () => ["explore", "--parts", "full"], {
    scripted: true,
    environment: hostileNames,
  }),
  reeve("rank", () => ["rank", "--catalogue", "--uncertainty", "--margin"]),
  reeve("rank-hostile", () => ["rank", "X", "TR1", "TR5", "--data", hostileData(inputs)], {
    environment: hostileNames,
  }),
  reeve("catalogue", () => ["catalogue"]),
  reeve("show", () => ["show", "TR5"]),
  reeve("show-bench", () => ["show", "M-F"]),
  reeve("show-wide", () => ["show", "1-P-2-P-3-P-4b-P-5b-P-6-P-1"]),
  reeve("show-hostile", () => ["show", "X"], {
    environment: hostileNames,
  }),
  reeve("size", () => ["size", "M-1b-B-2b-B-3b-M", "--vary", "sheath_angle=4..9",
    "--vary", "tip_angle=2..4", "--equal", "tips", "--draws", "10", "--hardware", hand]),
  reeve("size-target", () => ["size", "M-1-P-2-P-3-M", "--target", "1=2,others=1",
    "--vary", "sheath_angle=1..12", "--nominal"]),
  reeve("size-hostile", () => ["size", "X", "--vary", "sheath_angle=3..9", "--nominal"], {
    environment: hostileNames,
  }),
  reeve("diagnose-cause", () => ["diagnose", golden("cause")]),
  reeve("diagnose-none", () => ["diagnose", golden("none")]),
  reeve("diagnose-seven", () => ["diagnose", theSeven]),
  reeve("diagnose-alike", () => ["diagnose", golden("indistinguishable")]),
  reeve("diagnose-hostile", () => ["diagnose", hostileData(inputs)]),
];
