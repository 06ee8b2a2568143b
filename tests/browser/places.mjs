// Where things are; CMake says.
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { join } from "node:path";

function given(name) {
  const value = process.env[name];
  if (!value) throw new Error(`${name} is not set: run these tests with ctest`);
  return value;
}

export const executable = given("REEVE_EXECUTABLE");
export const sampleExecutable = given("REEVE_SAMPLE_PAGE");
export const chromiumExecutable = given("REEVE_CHROMIUM");
export const modules = given("REEVE_BROWSER_MODULES"); // the folder of node_modules
export const sources = given("REEVE_SOURCE_DIR");
export const written = given("REEVE_BROWSER_DIR"); // a folder for each page
export const screenshots = join(written, "screenshots");

export const pageFile = (name) => join(written, name, "index.html");
export const besidePage = (name, file) => readFileSync(join(written, name, file), "utf8");
export const jsonBesidePage = (name, file) => JSON.parse(besidePage(name, file));

// What the program prints.
export function reeveOutput(words, environment = {}) {
  return execFileSync(executable, words, {
    encoding: "utf8",
    env: { ...process.env, ...environment },
    stdio: ["ignore", "pipe", "pipe"],
    maxBuffer: 1 << 28,
  });
}

export const reeveJson = (words, environment) =>
  JSON.parse(reeveOutput([...words, "--format", "json"], environment));
