// Data files that `compare` refuses; tests/diagnosis has the details of each message.
#include <gtest/gtest.h>

#include <string>

#include "tests/cli/bad_line.hpp"

namespace reeve::testing {
namespace {

TEST(BadData, AreNamedWithFileLineAndColumn) {
  expect_all_bad({
      {"compare", "data is required"},
      {"compare --out out none.csv", "none.csv: cannot be read: No such file or directory"},
      {"compare --out out no_catalog", "no_catalog: is a directory: expected a CSV file"},
      {"compare --out out cell.csv",
       "cell.csv:2: column 'T1_N' = 'x': expected a number from -1000000000 "},
      {"compare --out out tiny.csv",
       "tiny.csv:3: column 'T1_N' = '1e-200': expected 0, or a tension of at least 1e-30 N"},
      {"diagnose tiny.csv", "tiny.csv:3: column 'T1_N' = '1e-200': expected 0, or"},
      {"compare --out out run.csv",
       "run.csv:2: column 'run' = 'AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA…': expected a "
       "name of at most 200 bytes, and it has 10000"},
      {"compare --out out name_of_column.csv",
       "name_of_column.csv:1: column 4 'AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA…': "
       "expected a name of at most 200 bytes, and it has 10000"},
      {"import log_run.csv --routing TR1 -o x.csv",
       "log_run.csv:2: column 'run' = 'AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA…': expected a name of "
       "at most 200 bytes, and it has 10000"},
      {"compare --out out name.csv",
       "name.csv:2: column 'routing' = 'TR9': routing 'TR9': no such name in the catalogue"},
      {"compare --out out ragged.csv", "ragged.csv:2:6: 2 fields: expected 3"},
      {"compare --out out alone.csv",
       "alone.csv: there is nothing to compare: expected rows with "},
      {"compare --out out ok.csv --hardware contact.toml",
       "contact.toml:1:10: hardware: contact 'a-T9'"},
      {"compare --out out ok.csv --format csv", "--format: csv not in {table,json,markdown,latex}"},
      {"compare ok.csv --out cell.csv",
       "--out 'cell.csv': expected a folder that can be written to: Not a directory"},
      {"compare residuals.csv --out .",
       "--out '.': './residuals.csv' would be written over the data: expected another place"},
  });
}

// Pages and tables of it would be no UTF-8 either.
TEST(BadData, ThatAreInLatin1AreRefusedByEveryCommand) {
  const std::string message =
      "latin1.csv:2:2: the byte FC ('ü' in Latin-1): expected text in UTF-8.";
  expect_all_bad({
      {"compare latin1.csv --out out", message},
      {"diagnose latin1.csv --out out", message},
      {"import latin1.csv --routing TR1 -o x.csv", message},
      {"compare ok.csv --hardware latin1.toml", "latin1.toml:1:"},
  });
}

TEST(BadData, OfADiagnosisAreNamedBeforeTheWork) {
  expect_all_bad({
      {"diagnose", "data is required"},
      {"diagnose ''", "data: Value '': expected a file or folder; see reeve diagnose --help"},
      {"compare ''", "data: Value '': expected a file or folder; see reeve compare --help"},
      {"diagnose ok.csv --terms ''", "--terms: Value '': expected a file or folder"},
      {"diagnose --out out --save-model model.toml none.csv",
       "none.csv: cannot be read: No such file or directory"},
      {"diagnose --out out --save-model model.toml empty.csv", "empty.csv: "},
      {"diagnose --out out --save-model model.toml cell.csv",
       "cell.csv:2: column 'T1_N' = 'x': expected a number from -1000000000 "},
      {"diagnose --out out --save-model model.toml nan.csv",
       "nan.csv:2: the row has no tension: expected a number in "},
      {"diagnose --out out --save-model model.toml ok.csv --unit stone",
       "--unit: 'stone': expected a unit of force (N, "},
      {"diagnose --out out --save-model model.toml ok.csv --map T1_N",
       "--map: 'T1_N': expected a column of the file, '=', "},
      {"diagnose ok.csv --map T1_N=T1 --map T1_N=T2",
       "ok.csv:1: column 4 'T1_N': expected one meaning, and 2 are given"},
      {"compare ok.csv --unit lbf --unit N",
       "ok.csv:1: the unit of all tensions: expected one unit, and 2 are given"},
      {"compare ok.csv --unit T1=kgf --unit T1_N=N",
       "ok.csv:1: column 4 'T1_N': expected one unit, and 2 are given"},
      {"compare norun.csv",
       "norun.csv:1: the header has no column 'run': expected a name or number for each run; name it "
       "with --map 'COLUMN=run'"},
      {"diagnose --out out --save-model model.toml ok.csv --terms none.toml",
       "none.toml: cannot be"},
      {"diagnose --out out --save-model model.toml ok.csv --group winch",
       ":1: the header has no column 'winch': expected "},
      {"diagnose --out out --save-model model.toml column.csv",
       "column.csv:1: column 4 't0_N': expected a tension "},
      {"diagnose --out out --save-model model.toml name.csv",
       "routing 'TR9': no such name in the catalogue"},
      {"diagnose --out out --save-model model.toml alone.csv",
       "alone.csv: there is nothing to diagnose: expected rows with "},
      {"diagnose --out out --save-model model.toml ok.csv --hardware contact.toml",
       "contact.toml:1:10: hardware: contact 'a-T9'"},
      {"diagnose --out out --save-model model.toml ok.csv --format csv",
       "--format: csv not in {table,json,markdown,latex}"},
  });
}

TEST(BadData, OfADiagnosisAreNotWrittenOver) {
  expect_all_bad({
      {"diagnose ok.csv --out cell.csv",
       "--out 'cell.csv': expected a folder that can be written to: Not a directory"},
      {"diagnose ok.csv --out cell.csv/below",
       "--out 'cell.csv/below': expected a folder that can be written to: Not a directory"},
      {"diagnose ok.csv --out ''", "--out '': expected a folder that can be"},
      {"diagnose residuals.csv --out .",
       "--out '.': './residuals.csv' would be written over the data: expected another place"},
      {"diagnose ok.csv --save-model ok.csv",
       "--save-model: 'ok.csv' would be written over the data: expected another place"},
      {"diagnose ok.csv --save-model missing/model.toml",
       "--save-model 'missing/model.toml': expected a file that can be written: No such file or "
       "directory"},
      {"diagnose ok.csv --save-model no_catalog",
       "--save-model 'no_catalog': expected the name of a file, not a folder"},
      {"diagnose ok.csv --save-model ''", "--save-model '': expected the name of"},
  });
}

TEST(BadOption, OfADiagnosisIsNamedWithItsRange) {
  const auto option = [](const std::string& name, const std::string& value,
                         const std::string& message) {
    return BadLine{{"diagnose", "ok.csv", name, value}, message};
  };
  const std::string alpha = "': expected a number from 0.0001 to 0.5";
  const std::string hold_out = "': expected a number from 0 to 0.9";
  expect_all_bad({
      option("--alpha", "0", "--alpha: Value '0" + alpha),
      option("--alpha", "0.6", "--alpha: Value '0.6" + alpha),
      option("--alpha", "0.00009", "--alpha: Value '0.00009" + alpha),
      option("--alpha", "nan", "--alpha: Value 'nan" + alpha),
      option("--alpha", "5%", "--alpha: Value '5%" + alpha),
      option("--hold-out", "-0.1", "--hold-out: Value '-0.1" + hold_out),
      option("--hold-out", "1", "--hold-out: Value '1" + hold_out),
      option("--seed", "-1", "--seed: Value -1 is negative: expected a whole number from 0"),
      option("--seed", "18446744073709551616",
             "--seed: Value 18446744073709551616 is too large: expected a whole number to "
             "18446744073709551615"),
      option("--replicates", "98", "--replicates: "),
      option("--replicates", "100001", "--replicates: "),
      option("--replicates", "-1", "--replicates: "),
      option("--replicates", "399",
             "--replicates '399': expected at least 400: with fewer no p-value falls below what "
             "--alpha 0.02 asks for"),
      {"diagnose ok.csv --replicates 1000 --alpha 0.0005",
       "--replicates '1000': expected at least 16000: with fewer"},
      option("--threads", "-1", "--threads: "),
      option("--threads", "1025", "--threads: "),
  });
}

}  // namespace
}  // namespace reeve::testing
