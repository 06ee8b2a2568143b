// Writes all pages, before the tests look at them.
import { spawnSync } from "node:child_process";
import { existsSync, rmSync } from "node:fs";
import { join } from "node:path";
import { pages } from "./pages.mjs";
import { pageFile, written } from "./places.mjs";

rmSync(written, { recursive: true, force: true });
for (const { name, command, environment } of pages) {
  const [program, ...words] = command(join(written, name));
  const start = Date.now();
  const { status, stderr } = spawnSync(program, words, {
    encoding: "utf8",
    env: { ...process.env, ...environment?.() },
    stdio: ["ignore", "ignore", "pipe"],
  });
  const wrote = existsSync(pageFile(name));
  console.log(`${name}: exit ${status}, ${Date.now() - start} ms${wrote ? "" : ", no page"}`);
  if (status !== 0 || !wrote) {
    console.error(`${[program, ...words].join(" ")}\n${stderr}`);
    process.exitCode = 1;
  }
}
