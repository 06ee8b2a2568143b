// The pages that the tests look at. A new page is a line here; every_page.test.mjs then holds it to
// what is asked of all.
import { executable, sampleExecutable } from "./places.mjs";

// `command` is given the folder to write to.
export const pages = [{ name: "sample", command: (folder) => [sampleExecutable, folder] }];
