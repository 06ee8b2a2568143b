// Inputs whose every free text would be a script, were it not treated as text.
import { copyFileSync, mkdirSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { sources } from "./places.mjs";

export const image = '<img src=x onerror="window.stolen=1">';
export const script = "</script><script>window.stolen=1</script>";
const quoted = (text) => `"${text.replaceAll('"', '""')}"`;

// What objects of JavaScript have already.
const inherited = {
  constructor: "M-1b-B-2b-M",
  toString: "M-1b-B-2b-F",
  __proto__name: "F-1b-P-2b-F",
};

// The shipped catalogue with one routing more, and some that are named like what every object has.
export function hostileCatalog(folder) {
  mkdirSync(folder, { recursive: true });
  const shipped = join(sources, "catalog");
  for (const file of readdirSync(shipped)) {
    if (file.endsWith(".toml")) copyFileSync(join(shipped, file), join(folder, file));
  }
  const text = ["title", "source", "notes"].map((key) => `${key} = '''${image}${script}'''\n`);
  writeFileSync(join(folder, "x.toml"), `name = "X"\nword = "M-1b-P-2b-M"\n${text.join("")}`);
  for (const [name, word] of Object.entries(inherited)) {
    const own = name.replace("name", "");
    writeFileSync(join(folder, `${name}.toml`), `name = "${own}"\nword = "${word}"\n`);
  }
  return folder;
}

// A golden data file under a hostile name, with hostile runs and a hostile column.
export function hostileData(folder) {
  mkdirSync(folder, { recursive: true });
  const lines = readFileSync(join(sources, "tests/golden/diagnose_cause.csv"), "utf8")
    .trimEnd()
    .split("\n");
  const first = lines.findIndex((line) => !line.startsWith("#"));
  const spoilt = lines.map((line, i) => {
    if (i < first) return line;
    if (i === first) return `${line},${quoted(image)}`;
    const [run, ...rest] = line.split(",");
    return [quoted(script + run), ...rest, i % 7].join(",");
  });
  const file = join(folder, `${image}.csv`);
  writeFileSync(file, `${spoilt.join("\n")}\n`);
  return file;
}
