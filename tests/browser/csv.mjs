// Reads the program's own CSV: quoted fields may hold commas, quotes and line ends.
function fields(text) {
  const rows = [[]];
  const pattern = /(?:"((?:[^"]|"")*)"|([^",\n]*))(,|\n|$)/gy;
  for (let match; pattern.lastIndex < text.length && (match = pattern.exec(text)); ) {
    const [, quoted, plain, end] = match;
    rows[rows.length - 1].push(quoted === undefined ? plain : quoted.replaceAll('""', '"'));
    if (end === "\n") rows.push([]);
  }
  return rows.filter((row) => row.length > 0);
}

// A value for each heading; comment lines before the headings are passed over.
export function csvRecords(text) {
  const [headings, ...rows] = fields(text.replace(/^(#.*\n)*/, ""));
  return rows.map((row) => Object.fromEntries(headings.map((heading, i) => [heading, row[i]])));
}
