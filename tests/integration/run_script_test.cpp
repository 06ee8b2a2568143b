// `./run` on a machine that lacks packages, with apt and dpkg that only say what they are asked.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/support/has.hpp"
#include "tests/support/process.hpp"
#include "tests/support/temporary_folder.hpp"

namespace reeve::testing {
namespace {

namespace fs = std::filesystem;

// A copy of ./run in which libfmt-dev is missing; `seen` is what stood on stderr when apt-get was
// asked to install it, which then fails.
struct BareMachine {
  BareMachine() {
    const fs::path source = REEVE_SOURCE_DIR;
    fs::create_directories(folder.path() / "scripts");
    fs::copy(source / "run", folder.path() / "run");
    fs::copy(source / "scripts/packages.sh", folder.path() / "scripts/packages.sh");
    program("sudo", "[[ $1 == -v ]] || exec \"$@\"");
    program("npm", "");
    program(
        "dpkg-query",
        "shift 3\n"
        "for package; do [[ $package == libfmt-dev ]] || printf '%s ' \"installed=$package\"; done");
    program("apt-get",
            "case \" $* \" in\n"
            "  *' update '*) ;;\n"
            "  *' --print-uris '*)\n"
            "    echo '0 upgraded, 7 newly installed, 0 to remove and 3 not upgraded.'\n"
            "    echo 'Need to get 12.3 MB/20 MB of archives.'\n"
            "    echo 'After this operation, 45.6 MB of additional disk space will be used.' ;;\n"
            "  *) cp err seen; exit 100 ;;\n"
            "esac");
    result = run_process({"/bin/bash", "-c", "PATH=$PWD/bin:$PATH ./run --version 2>err"},
                         {.directory = folder.path()});
    said = read_text(folder.path() / "err");
  }

  void program(const std::string& name, const std::string& script) const {
    fs::create_directories(folder.path() / "bin");
    folder.write("bin/" + name, "#!/bin/bash\n" + script + "\n");
    fs::permissions(folder.path() / "bin" / name, fs::perms::owner_all);
  }

  TemporaryFolder folder;
  ProcessResult result;
  std::string said;
};

TEST(RunScript, AnnouncesWhatItInstallsBeforeItDoes) {
  const BareMachine machine;
  const fs::path seen = machine.folder.path() / "seen";
  ASSERT_TRUE(fs::exists(seen)) << machine.said;
  EXPECT_TRUE(has(read_text(seen),
                  "reeve: installing libfmt-dev (7 packages, 12.3 MB/20 MB to fetch, 45.6 MB on "
                  "disk) …\n"))
      << read_text(seen);
  EXPECT_EQ(machine.result.out, "");
  EXPECT_EQ(machine.result.exit_code, 3);
  EXPECT_TRUE(machine.said.ends_with("reeve: apt-get could not install: libfmt-dev\n"))
      << machine.said;
}

}  // namespace
}  // namespace reeve::testing
