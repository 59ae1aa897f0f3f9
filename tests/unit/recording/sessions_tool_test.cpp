// Two sessions at the panel in the tool: exit codes and messages.
#include "support/strings.hpp"
#include "support/temporary_folder.hpp"
#include "support/tool.hpp"

namespace symplant::test {
namespace {

std::string session(const std::string& hash, const std::string& title) {
  return R"({"symplant-session":1,"plant":"cell","model_hash":")" + hash +
         R"(","seed":0,"t":9000000000,"acts":[],"findings":[],"exercise":{"name":"air","title":")" + title +
         R"(","text":"","state":"over","step":1,"steps":[{"text":"Close it","does":"","state":"done","t":3000000000}],)" +
         R"("score":5,"most":5,"points":[],"since":1000000000,"took":2000000000}})";
}

ToolRun compared(const std::vector<std::string>& arguments) {
  base::DiskFileSystem files;
  std::vector<std::string> all{"compare"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  return run_tool(all, files);
}

TEST_CASE("Two sessions are compared as text or as a page, and a difference is no failure") {
  const TemporaryFolder folder;
  const std::string expert = folder.write("expert.session.json", session("aa", "No air"));
  const std::string trainee = folder.write("anna.session.json", session("aa", "Start up"));
  const ToolRun text = compared({expert, trainee});
  CHECK(text.code == 0);
  CHECK(contains(text.err, "warning: the sessions are of different exercises"));
  CHECK(contains(text.out, "1: Close it  2 s     2 s      +0 s        1.00\n"));
  const std::string page = folder / "page.html";
  const ToolRun html = compared({expert, expert, "--html", page});
  CHECK(html.code == 0);
  CHECK(html.out == "expert 2 s and 5 points, trainee 2 s and 5 points\n");
  CHECK(html.err.empty());
  CHECK(contains(*base::DiskFileSystem().read(page), "<h1>No air: expert and trainee</h1>"));
}

TEST_CASE("A session is compared with a session of the same plant only") {
  const TemporaryFolder folder;
  const std::string expert = folder.write("expert.session.json", session("aa", "No air"));
  const std::string other = folder.write("other.session.json", session("bb", "No air"));
  const std::string trace = folder.write("run.jsonl", "{\"symplant-trace\":1}\n");
  const std::string half = folder.write("half.session.json", session("aa", "No air").substr(0, 200));
  const auto rejects = [](const std::vector<std::string>& arguments, const std::string& message) {
    const ToolRun run = compared(arguments);
    INFO(run.err);
    CHECK(run.code == 2);
    CHECK(run.out.empty());
    CHECK(contains(run.err, message));
  };
  rejects({expert, other}, "error: the sessions are of two plants");
  rejects({expert, trace}, "run.jsonl` is not a session at the panel");
  rejects({trace, expert}, "run.jsonl` is not a session at the panel");
  rejects({expert, half}, "half.session.json` is not a whole session");
  rejects({expert, folder / "none.json"}, "error: cannot read");
  rejects({expert}, "error: give the session of the expert, then that of the trainee");
  rejects({expert, expert, "--format", "junit"}, "or with `--html FILE` a page");
  rejects({expert, expert, "--html", expert}, "is an input");
}

}  // namespace
}  // namespace symplant::test
