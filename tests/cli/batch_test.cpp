// SPDX-License-Identifier: GPL-3.0-or-later
// `loopmend batch`: the bits of `fill`, one row for each scan whatever becomes of it, and nothing done twice or lost.
#include "cli/run_program.h"

#include "io/write_mesh.h"
#include "samples/analytic_surfaces.h"

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <sstream>
#include <thread>

namespace loopmend {
namespace {

namespace fs = std::filesystem;
using test::text_of;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::Pair;
using testing::UnorderedElementsAre;

/// A sphere with a hole whose size tells it from others.
void write_ball(const fs::path& path, double above, int level = 3) {
  fs::create_directories(path.parent_path());
  write_mesh(path, cut(make_icosphere(level), [&](const Vec3& p) { return p.z() > above; }));
}

/// Four triangles that have corners in common, but not the vertices: nothing is a hole there.
void write_split(const fs::path& path) {
  std::ofstream(path) << "OFF\n12 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 0\n0 0 1\n1 0 0\n0 0 0\n0 1 0\n0 0 1\n1 0 0\n0 0 1\n"
                         "0 1 0\n3 0 2 1\n3 3 5 4\n3 6 8 7\n3 9 11 10\n";
}

class Batch : public test::ProgramTest {
 protected:
  const fs::path scans = work / "scans", results = work / "results";

  test::Outcome batch(const std::string& options = "", const std::string& inputs = "scans") {
    return test::loopmend_program("batch " + path(inputs) + "-o " + path("results") + "--pictures none " + options);
  }

  /// @returns the words of two columns of the summary, those of scans and of their status.
  std::map<std::string, std::string> statuses() const {
    std::map<std::string, std::string> table;
    std::istringstream lines(text_of(results / "summary.csv"));
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line)) {
      std::istringstream fields(line);
      std::string name, input, status;
      std::getline(fields, name, ',');
      std::getline(fields, input, ',');
      std::getline(fields, status, ',');
      table[name] = status;
    }
    return table;
  }

  /// The scans that runs of `fill` were begun for, in order, since the first `known` lines of the record.
  std::vector<std::string> begun(std::size_t known = 0) const {
    std::vector<std::string> names;
    std::istringstream lines(text_of(results / "batch.jsonl"));
    std::string line;
    for (std::size_t k = 0; std::getline(lines, line); ++k)
      if (const std::string begin = "{\"begun\":\""; k >= known && line.starts_with(begin))
        names.push_back(line.substr(begin.size(), line.size() - begin.size() - 2));
    return names;
  }
  std::size_t lines_of_record() const {
    const std::string record = text_of(results / "batch.jsonl");
    return static_cast<std::size_t>(std::count(record.begin(), record.end(), '\n'));
  }

  std::string filled_alone(const fs::path& scan, const std::string& options = "") const {
    const fs::path alone = work / ("alone" + scan.extension().string());
    EXPECT_EQ(
        test::loopmend_program("fill '" + scan.string() + "' -o '" + alone.string() + "' --quiet " + options).code, 0);
    return text_of(alone);
  }

  pid_t start(const std::vector<std::string>& options) {
    std::vector<std::string> words{"loopmend", "batch", scans, "-o", results, "--pictures", "none"};
    words.insert(words.end(), options.begin(), options.end());
    const pid_t child = fork();
    if (child != 0) return child;
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) std::signal(signal, SIG_DFL);
    if (!std::freopen((work / "said").c_str(), "w", stderr) || !std::freopen("/dev/null", "w", stdout)) _exit(98);
    execv(LOOPMEND_PROGRAM, arguments.data());
    _exit(99);
  }

  void wait_for(const std::function<bool()>& holds) const {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(120);
    while (!holds() && std::chrono::steady_clock::now() < end)
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    ASSERT_TRUE(holds()) << text_of(results / "batch.jsonl");
  }

  static std::vector<pid_t> children_of(pid_t process) {
    const std::string id = std::to_string(process);
    std::ifstream list("/proc/" + id + "/task/" + id + "/children");
    return {std::istream_iterator<pid_t>(list), {}};
  }
  static bool lives(pid_t process) {
    std::ifstream file("/proc/" + std::to_string(process) + "/stat");
    std::string id, name, state;
    return (file >> id >> name >> state) && state != "Z";
  }

  std::vector<std::string> hidden_files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(results))
      if (entry.path().filename().string().starts_with(".")) names.push_back(entry.path());
    return names;
  }
};

TEST_F(Batch, FillsEachScanAsFillDoes) {
  write_ball(scans / "a.ply", 0.9);
  write_ball(scans / "b.stl", 0.8);
  write_ball(scans / "inner" / "a.ply", 0.7);
  const auto run = batch("--jobs 2");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("3 scans: 3 filled, 0 of them to look at, 0 left open, 0 errors"));
  for (const char* name : {"a.ply", "b.stl", "inner/a.ply"}) {
    EXPECT_EQ(text_of(results / "filled" / name), filled_alone(scans / name)) << name;
    EXPECT_TRUE(fs::exists(results / "reports" / (std::string(name) + ".json"))) << name;
  }
  EXPECT_NE(text_of(results / "filled/a.ply"), text_of(results / "filled/inner/a.ply"));
  EXPECT_THAT(statuses(), ElementsAre(Pair("a.ply", "filled"), Pair("b.stl", "filled"), Pair("inner/a.ply", "filled")));
}

TEST_F(Batch, HandsOptionsToFillAndKeepsSameNamesApart) {
  write_ball(work / "monday" / "scan.ply", 0.9);
  write_ball(work / "tuesday" / "scan.ply", 0.8);
  const auto run = test::loopmend_program("batch " + path("monday/scan.ply") + path("tuesday/scan.ply") + "-o " +
                                          path("results") + "--pictures none --format off -- --flow none --density 2");
  EXPECT_EQ(run.code, 0) << run.err;
  for (const char* day : {"monday", "tuesday"})
    EXPECT_THAT(text_of(results / "filled" / day / "scan.ply.off"), HasSubstr("OFF")) << day;
  EXPECT_THAT(text_of(results / "reports/monday/scan.ply.off.json"), HasSubstr("--flow none --density 2"));
  EXPECT_THAT(text_of(results / "reports/monday/scan.ply.off.json"), HasSubstr("\"method\": \"initial_patch\""));
}

TEST_F(Batch, DoesOnlyWhatIsMissingOrHasChanged) {
  for (const char* name : {"a.ply", "b.ply", "c.ply"}) write_ball(scans / name, 0.9);
  ASSERT_EQ(batch().code, 0);
  EXPECT_THAT(begun(), UnorderedElementsAre("a.ply", "b.ply", "c.ply"));

  std::size_t known = lines_of_record();
  EXPECT_THAT(batch().out, HasSubstr("3 were complete before"));
  EXPECT_THAT(begun(known), IsEmpty());

  write_ball(scans / "a.ply", 0.8);
  fs::remove(results / "filled/b.ply");
  ASSERT_EQ(batch().code, 0);
  EXPECT_THAT(begun(known), UnorderedElementsAre("a.ply", "b.ply"));
  EXPECT_EQ(text_of(results / "filled/a.ply"), filled_alone(scans / "a.ply"));

  known = lines_of_record();
  ASSERT_EQ(batch("-- --density 2").code, 0);
  EXPECT_THAT(begun(known), UnorderedElementsAre("a.ply", "b.ply", "c.ply"));
  known = lines_of_record();
  ASSERT_EQ(batch("--again all -- --density 2").code, 0);
  EXPECT_THAT(begun(known), UnorderedElementsAre("a.ply", "b.ply", "c.ply"));
}

TEST_F(Batch, TellsWhatWentWrongInARowAndByItsExitCode) {
  write_ball(scans / "a.ply", 0.9);
  write_split(scans / "split.off");
  EXPECT_EQ(batch("--no-auto --fail-on error").code, 0);
  EXPECT_EQ(batch("--no-auto --fail-on open").code, 1);
  std::ofstream(scans / "notes.ply") << "This is not a mesh.\n";
  EXPECT_EQ(batch("--no-auto --fail-on never").code, 0);
  const auto run = batch("--no-auto");
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.err, HasSubstr("notes.ply: does not begin with \"ply\""));
  EXPECT_THAT(statuses(), ElementsAre(Pair("a.ply", "filled"), Pair("notes.ply", "error"), Pair("split.off", "open")));
  EXPECT_THAT(text_of(results / "summary.csv"), HasSubstr("does not begin with \"\"ply\"\""));
  EXPECT_THAT(text_of(results / "summary.csv"), HasSubstr("crack: nothing is missing"));
  EXPECT_THAT(text_of(results / "summary.html"), HasSubstr("does not begin with &quot;ply&quot;"));

  const std::size_t known = lines_of_record();
  EXPECT_EQ(batch("--no-auto --fail-on never --again open").code, 0);
  EXPECT_THAT(begun(known), UnorderedElementsAre("notes.ply", "split.off"));
  EXPECT_EQ(batch("-- --stitch").code, 1);
  EXPECT_EQ(statuses()["split.off"], "nothing");
}

TEST_F(Batch, PreparesEachScanUnlessAskedNotTo) {
  fs::create_directories(scans);
  write_split(scans / "split.off");
  EXPECT_EQ(batch("--no-auto --fail-on open").code, 1);
  EXPECT_EQ(batch("--fail-on open").code, 0);  // another option: filled again
  EXPECT_THAT(statuses(), ElementsAre(Pair("split.off", "nothing")));
  EXPECT_THAT(text_of(results / "reports" / "split.off.json"), HasSubstr("\"stitched\""));
}

TEST_F(Batch, RemovesWhatAnEarlierRunMadeOfAScanThatIsNoLongerReadable) {
  write_ball(scans / "a.ply", 0.9);
  ASSERT_EQ(batch().code, 0);
  std::ofstream(scans / "a.ply") << "This is not a mesh.\n";
  EXPECT_EQ(batch().code, 1);
  EXPECT_FALSE(fs::exists(results / "filled/a.ply"));
  EXPECT_FALSE(fs::exists(results / "reports/a.ply.json"));
  EXPECT_THAT(text_of(results / "summary.csv"), HasSubstr("What an earlier run made of it was removed."));
}

TEST_F(Batch, ReplacesNothingThatItDidNotWrite) {
  write_ball(scans / "a.ply", 0.9);
  write_ball(scans / "b.ply", 0.9);
  fs::create_directories(results / "filled");
  std::ofstream(results / "filled/a.ply") << "mine";
  auto run = batch();
  EXPECT_EQ(run.code, 1);
  EXPECT_EQ(text_of(results / "filled/a.ply"), "mine");
  EXPECT_THAT(statuses(), ElementsAre(Pair("a.ply", "error"), Pair("b.ply", "filled")));
  EXPECT_THAT(run.err, HasSubstr("no batch wrote it"));

  std::ofstream(results / "filled/b.ply", std::ios::app) << "a line of mine\n";  // has changed since
  EXPECT_EQ(batch().code, 1);
  EXPECT_THAT(text_of(results / "filled/b.ply"), HasSubstr("a line of mine"));

  run = batch("--overwrite");
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.err, HasSubstr("is overwritten"));
  EXPECT_EQ(text_of(results / "filled/a.ply"), filled_alone(scans / "a.ply"));
  EXPECT_EQ(text_of(results / "filled/b.ply"), text_of(results / "filled/a.ply"));
}

TEST_F(Batch, KeepsASummaryOfSomebodyElse) {
  write_ball(scans / "a.ply", 0.9);
  fs::create_directories(results);
  std::ofstream(results / "summary.csv") << "mine";
  expect_refused(batch(), 2, "summary.csv is there, and no batch wrote it");
  EXPECT_EQ(text_of(results / "summary.csv"), "mine");
  EXPECT_EQ(batch("--overwrite").code, 0);
  EXPECT_EQ(batch().code, 0);
}

TEST_F(Batch, TakesAManifest) {
  write_ball(work / "a.ply", 0.9);
  write_ball(work / "with blank" / "b.ply", 0.8);
  std::ofstream(work / "list.jsonl") << "{\"input\": \"a.ply\", \"output\": \"first/ball.off\"}\n\n"
                                        "{\"input\": \"with blank/b.ply\", \"options\": [\"--flow\", \"none\"]}\n";
  const auto run = batch("", "list.jsonl");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(statuses(), ElementsAre(Pair("first/ball.off", "filled"), Pair("with blank/b.ply", "filled")));
  EXPECT_EQ(text_of(results / "filled/with blank/b.ply"), filled_alone(work / "with blank" / "b.ply", "--flow none"));
}

TEST_F(Batch, TakesNamesAsTheyAreTyped) {
  write_ball(scans / "a.ply", 0.9);
  write_ball(scans / "-b.ply", 0.8);
  const fs::path before = fs::current_path();
  fs::current_path(scans);
  for (const char* inputs : {"a.ply ./-b.ply", ".", "../scans/", "./ a.ply", "./../scans/a.ply ."}) {
    fs::remove_all(results);
    const auto run = test::loopmend_program(std::string("batch ") + inputs + " -o ../results --pictures none");
    EXPECT_EQ(run.code, 0) << inputs << run.err;
    EXPECT_THAT(statuses(), ElementsAre(Pair("-b.ply", "filled"), Pair("a.ply", "filled"))) << inputs;
  }
  EXPECT_THAT(test::loopmend_program("batch a.ply ./-b.ply -o ../results --pictures none").out,
              HasSubstr("2 were complete before"));
  fs::current_path(before);
}

TEST_F(Batch, RefusesWhatItCannotDo) {
  write_ball(scans / "a.ply", 0.9);
  const auto manifest = [&](const std::string& line) {
    std::ofstream(work / "list.jsonl") << "\n" << line << "\n";
    return batch("", "list.jsonl");
  };
  expect_refused(manifest("a.ply"), 2, "list.jsonl, line 2: is no object with an \"input\"");
  expect_refused(manifest(R"({"input": "a.ply", "ouput": "b.ply"})"), 2, "\"ouput\" is not one of");
  expect_refused(manifest(R"({"input": "a.ply", "output": "../b.ply"})"), 2, "within the folder of the results");
  expect_refused(manifest(R"({"input": "a.ply", "options": "--stitch"})"), 2, "takes an array of texts");
  expect_refused(manifest(R"({"input": "a.ply", "options": ["--flow", "wrong"]})"), 2, "--flow");
  expect_refused(batch("-- --stich"), 2, "options of fill");
  expect_refused(batch("-- --report x.json"), 2, "--report is not for batch");
  expect_refused(batch("-- --keep-partial"), 2, "--keep-partial is not for batch");
  expect_refused(batch("-- -o other.ply"), 2, "options of fill");
  expect_refused(batch("-- other.ply"), 2, "options of fill");
  fs::create_directories(work / "empty");
  expect_refused(batch("", "empty"), 2, "there is no scan in");
  EXPECT_FALSE(fs::exists(results));
  ASSERT_EQ(batch().code, 0);
  expect_refused(batch("", "results/filled/a.ply"), 2, "lies in the folder of the results");
  EXPECT_EQ(test::loopmend_program("batch " + path("") + "-o " + path("results") + "--pictures none").code, 0);
  EXPECT_THAT(statuses(), ElementsAre(Pair("scans/a.ply", "filled")));  // none of its own results
}

TEST_F(Batch, GoesOnAfterItWasKilled) {
  for (const char* name : {"a.ply", "b.ply", "c.ply", "d.ply"}) write_ball(scans / name, 0.9, 5);
  const pid_t killed = start({"--jobs", "2", "--", "--threads", "1"});
  wait_for(
      [&] { return text_of(results / "batch.jsonl").find("\"filled\"") != std::string::npos && begun().size() > 2; });
  const std::vector<pid_t> workers = children_of(killed);
  kill(killed, SIGKILL);
  waitpid(killed, nullptr, 0);
  for (const pid_t worker : workers) wait_for([&] { return !lives(worker); });
  const std::string record = text_of(results / "batch.jsonl");
  EXPECT_FALSE(fs::exists(results / "summary.csv"));
  std::ofstream(results / "batch.jsonl", std::ios::app) << R"({"filled":"d.p)";  // cut off in the middle of a line

  const std::size_t known = lines_of_record();
  const auto run = batch("-- --threads 1");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("4 scans: 4 filled"));
  EXPECT_LT(begun(known).size(), 4u);
  for (const std::string& name : begun(known))
    EXPECT_THAT(record, Not(HasSubstr("{\"filled\":\"" + name))) << "was done twice";
  for (const char* name : {"a.ply", "b.ply", "c.ply", "d.ply"})
    EXPECT_EQ(text_of(results / "filled" / name), filled_alone(scans / name)) << name;
  EXPECT_THAT(hidden_files(), IsEmpty());
}

TEST_F(Batch, LosesOneScanWhenOneWorkerIsKilled) {
  for (const char* name : {"a.ply", "b.ply", "c.ply"}) write_ball(scans / name, 0.9, name[0] == 'a' ? 6 : 3);
  const pid_t run = start({"--jobs", "1"});
  std::vector<pid_t> workers;
  wait_for([&] { return !(workers = children_of(run)).empty() && !begun().empty(); });
  kill(workers.front(), SIGKILL);
  int status = 0;
  ASSERT_EQ(waitpid(run, &status, 0), run);
  EXPECT_EQ(WEXITSTATUS(status), 1);
  EXPECT_THAT(statuses(), ElementsAre(Pair("a.ply", "error"), Pair("b.ply", "filled"), Pair("c.ply", "filled")));
  EXPECT_THAT(text_of(results / "summary.csv"), HasSubstr("its process was killed"));
  EXPECT_EQ(batch().code, 0);
  EXPECT_EQ(statuses()["a.ply"], "filled");
  EXPECT_THAT(hidden_files(), IsEmpty());
}

TEST_F(Batch, WritesTheSummaryOfWhatIsDoneWhenStopped) {
  for (const char* name : {"a.ply", "b.ply", "c.ply"}) write_ball(scans / name, 0.9, name[0] == 'a' ? 3 : 6);
  const pid_t run = start({"--jobs", "1"});
  wait_for([&] { return begun().size() == 2; });
  expect_refused(batch(), 2, "another batch is at work");
  kill(run, SIGTERM);
  int status = 0;
  ASSERT_EQ(waitpid(run, &status, 0), run);
  EXPECT_EQ(WEXITSTATUS(status), 128 + SIGTERM) << text_of(work / "said");
  EXPECT_THAT(statuses(), ElementsAre(Pair("a.ply", "filled"), Pair("b.ply", "waiting"), Pair("c.ply", "waiting")));
  EXPECT_THAT(hidden_files(), IsEmpty());
}

TEST_F(Batch, CallsFilledOnlyWhatHasAPatch) {
  fs::create_directories(scans);
  std::ofstream(scans / "sheet.off") << "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";
  write_mesh(scans / "whole.ply", make_icosphere(1));
  write_ball(scans / "open.ply", 0.9);
  const auto run = batch("--fail-on open");
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.out,
              HasSubstr("3 scans: 1 filled, 0 of them to look at, 0 left open, 0 errors, 2 with nothing to fill;"));
  EXPECT_THAT(statuses(),
              ElementsAre(Pair("open.ply", "filled"), Pair("sheet.off", "nothing"), Pair("whole.ply", "nothing")));
  const std::string page = text_of(results / "summary.html");
  EXPECT_THAT(page, HasSubstr("1 filled, 0 of them to look at, 2 with nothing to fill, 0 left open"));
  EXPECT_THAT(page, HasSubstr("<td class='status'>filled</td><td class='good'>good</td><td class='n'>0.0"));
  EXPECT_THAT(page, HasSubstr("<ul><li>the surface is closed</li></ul>"));
  EXPECT_THAT(page, HasSubstr("<li>loop 1: skipped, outline of an open sheet"));
}

TEST_F(Batch, ShowsPicturesInAPageThatNeedsNoOtherFile) {
  write_ball(scans / "a & b.ply", 0.9);
  write_split(scans / "split.off");
  ASSERT_EQ(
      test::loopmend_program("batch " + path("scans") + "-o " + path("results") + "--no-auto --pictures open").code, 0);
  EXPECT_FALSE(fs::exists(results / "pictures/a & b.ply.png"));
  EXPECT_TRUE(fs::exists(results / "pictures/split.off.png"));
  ASSERT_EQ(test::loopmend_program("batch " + path("scans") + "-o " + path("results")).code, 0);
  const std::string page = text_of(results / "summary.html"), png = text_of(results / "pictures/a & b.ply.png");
  EXPECT_TRUE(png.starts_with("\x89PNG"));
  EXPECT_THAT(page, HasSubstr("a &amp; b.ply"));
  EXPECT_THAT(page, HasSubstr("href='filled/a%20%26%20b.ply'"));
  EXPECT_THAT(page, HasSubstr("data:image/png;base64,iVBORw0KGgo"));
  EXPECT_THAT(page, Not(HasSubstr("src='http")));
}

}  // namespace
}  // namespace loopmend
