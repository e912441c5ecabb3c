#include "support/locked_folder.h"

namespace taut::test {

namespace {

std::string in_quotes(const std::filesystem::path& path) { return "'" + path.string() + "'"; }

}  // namespace

Outcome run_taut_where_nothing_can_be_written(const Folder& folder, const std::string& arguments) {
  // A copy of the program, as nobody need not reach the build.
  const Folder elsewhere;
  const std::string there = in_quotes(folder.path()), copy = in_quotes(elsewhere / "taut");
  return run_script("cp \"$taut\" " + copy + " && chmod 755 " + in_quotes(elsewhere.path()) + " && chmod 555 " + there +
                    " && cd " + there + " || exit 99\nas=\n" +
                    "[ \"$(id -u)\" = 0 ] && as='setpriv --reuid=65534 --regid=65534 --clear-groups'\n" +
                    "$as sh -c ': >written' 2>/dev/null && exit 98\n" +  // the test would prove nothing
                    "$as " + copy + " " + arguments + "\ncode=$?\nchmod 755 . || exit 97\nexit $code");
}

}  // namespace taut::test
