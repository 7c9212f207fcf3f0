// SPDX-License-Identifier: MIT
#include "workshop.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>
#include <wordexp.h>

#include <algorithm>
#include <sstream>

#include "cache.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "core/plain_text.hpp"
#include "material/starter.hpp"

namespace texel::grade {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

/// A command's words, as a shell takes them apart; none where it is more than one command.
Words split(const std::string& command) {
  wordexp_t found{};
  if (::wordexp(command.c_str(), &found, WRDE_NOCMD) != 0) return {};
  Words words(found.we_wordv, found.we_wordv + found.we_wordc);
  ::wordfree(&found);
  return words;
}

/// The last lines of a log, where the errors are.
std::string end_of(const std::string& log) {
  constexpr std::size_t most = 2000;
  return plain_lines(log.size() > most ? log.substr(log.size() - most) : log);
}

/// Runs a trusted program in a folder and returns what it printed.
std::string output_of(const Words& command, const fs::path& folder, double seconds) {
  Confines plain;
  plain.working_folder = folder;
  plain.limits.wall_seconds = plain.limits.cpu_seconds = seconds;
  plain.limits.memory = plain.limits.address_space = 64ULL << 30U;
  plain.limits.disk = 4ULL << 30U;
  plain.limits.processes = 4096;
  plain.limits.kept_output = plain.limits.output = 64U << 20U;
  for (const char* name : {"CCACHE_DIR", "HOME"})
    if (const char* value = std::getenv(name)) plain.environment.emplace_back(name, value);
  const Outcome outcome = run_plainly(plain, command);
  if (!outcome.succeeded())
    throw Error::failed(
        fmt::format("'{}' fails with exit code {}", fmt::join(command, " "), outcome.exit_code),
        {folder.string()}, "it says:\n" + end_of(outcome.output + outcome.errors));
  return outcome.output;
}

/// Whether programs do not depend on a file of the starter.
bool is_for_people(const std::string& path) {
  return path.starts_with("docs/") || fs::path(path).extension() == ".md" ||
         path.find("/expected/") != path.npos;
}

/// The word after `option`, or null.
std::string* word_after(Words& words, const std::string& option) {
  const auto found = std::ranges::find(words, option);
  return found == words.end() || found + 1 == words.end() ? nullptr : &found[1];
}

std::string& after(Words& words, const std::string& option) {
  std::string* const word = word_after(words, option);
  if (word == nullptr) throw Error::failed(fmt::format("a build command has no '{}'", option));
  return *word;
}

void drop(Words& words, const std::string& option, std::ptrdiff_t count) {
  const auto found = std::ranges::find(words, option);
  if (found != words.end()) words.erase(found, found + count);
}

/// Measured: lab.cpp takes 4 s, 325 MB resident; a machine under load ten times as long.
constexpr double kProcessorSeconds = 60, kWallSeconds = 240;

/// Writes without end are cut, colours and paths of ours go.
std::string readable_log(std::string text, const fs::path& sources, const fs::path& tree) {
  for (const std::string& folder : {sources.string() + "/", tree.string() + "/"})
    for (std::size_t at = 0; (at = text.find(folder, at)) != text.npos;) text.erase(at, folder.size());
  constexpr std::size_t most = 8000;
  if (text.size() > most) text = text.substr(0, most) + "\n… (cut here)";
  return plain_lines(text);
}

}  // namespace

Workshop::Workshop(BuiltTree tree, fs::path cache, Run how)
    : tree_(std::move(tree)), cache_(std::move(cache)), run_(how) {
  if (!fs::exists(tree_.build / "build.ninja"))
    throw Error::failed("is not a Ninja build", {tree_.build.string()},
                        "build the course first: ./run build");
  fs::create_directories(cache_);
}

const Workshop::Recipe& Workshop::recipe(const std::string& program) {
  const std::scoped_lock lock(mutex_);
  if (const auto known = recipes_.find(program); known != recipes_.end()) return known->second;
  Recipe recipe;
  std::istringstream lines(output_of({"ninja", "-t", "commands", "bin/" + program}, tree_.build, 60));
  for (std::string line; std::getline(lines, line);) {
    // ": && c++ … -o PROGRAM.new … && mv PROGRAM.new PROGRAM && :" is how CMake has a linker run.
    if (line.starts_with(": && ")) line = line.substr(5, line.find(" && ", 5) - 5);
    Words words = split(line);
    const auto launcher =
        std::ranges::find_if(words, [](const std::string& word) { return word.ends_with("/ccache"); });
    if (launcher != words.end()) words.erase(words.begin(), launcher + 1);
    if (const std::string* source = word_after(words, "-c")) {
      const std::string path = fs::path(*source).lexically_relative(tree_.source).generic_string();
      // A student's warnings are no errors, and nobody reads the lists of what was read.
      drop(words, "-Werror", 1), drop(words, "-MD", 1), drop(words, "-MT", 2), drop(words, "-MF", 2);
      recipe.compile[path] = words;
    } else if (const std::string* made = word_after(words, "-o");
               made != nullptr && *made == "bin/" + program + ".new") {
      std::erase_if(words, [](const std::string& w) { return w.starts_with("-Wl,--dependency-file"); });
      recipe.link = words;
    }
  }
  if (recipe.link.empty() || recipe.compile.empty())
    throw Error::failed(fmt::format("does not know how to build '{}'", program), {tree_.build.string()},
                        "build the course again: ./run build");
  return recipes_[program] = recipe;
}

fs::path Workshop::new_folder(const char* what) {
  const std::scoped_lock lock(mutex_);
  const fs::path folder = cache_ / fmt::format("{}-{}-{}", what, ::getpid(), count_++);
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

Outcome Workshop::run(const Words& command, const std::vector<fs::path>& readable, const fs::path& out,
                      double wall_seconds) const {
  Confines confines;
  confines.read_only = readable;
  confines.read_only.push_back(tree_.source);
  if (tree_.build.lexically_relative(tree_.source).generic_string().starts_with(".."))
    confines.read_only.push_back(tree_.build);
  confines.writable = {out};
  confines.working_folder = tree_.build;
  confines.limits.cpu_seconds = kProcessorSeconds, confines.limits.wall_seconds = wall_seconds;
  return run_(confines, command);
}

Workshop::Object Workshop::compile(const Recipe& recipe, const std::string& path, const std::string& text,
                                   TimeBudget* budget) {
  Words command = recipe.compile.at(path);
  const std::string name = fs::path(after(command, "-o")).filename().string();
  const std::string key =
      fingerprint({tree_.fingerprint, fmt::format("{}", fmt::join(command, "\n")), path, text, name});
  std::unique_lock all(mutex_);
  Compilation& own = compilations_[key];
  all.unlock();
  // The labs of one student, side by side, all want the file: the first compiles it.
  const std::scoped_lock compiling(own.mutex);
  const fs::path kept = cache_ / "objects" / key;
  if (is_cached(kept)) {
    if (fs::exists(kept / name)) return {kept / name, key, {}};
    return {{}, key, read_file(kept / "log")};
  }
  if (!own.stopped.empty()) return {{}, key, own.stopped};
  const double seconds = budget == nullptr ? kWallSeconds : std::min(kWallSeconds, budget->load());
  if (seconds <= 0) return {{}, key, "not compiled: the submission used up its time\n"};
  const fs::path work = new_folder("compile"), sources = work / "source", out = work / "out";
  fs::create_directories((sources / path).parent_path());
  fs::create_directories(out);
  write_file(sources / path, text);
  after(command, "-c") = (sources / path).string();
  after(command, "-o") = (out / name).string();
  // Headers beside the file, as the compiler would look for them there.
  command.push_back("-iquote");
  command.push_back((tree_.source / path).parent_path().string());
  command.push_back("-fdiagnostics-color=never");
  const Outcome outcome = run(command, {sources}, out, seconds);
  if (budget != nullptr) *budget -= outcome.wall_seconds;
  const bool done = outcome.succeeded() && fs::is_regular_file(out / name);
  std::string log;
  if (!done) {
    log = readable_log(outcome.errors, sources, tree_.source);
    if (outcome.limit != Limit::none)
      log += fmt::format("\nthe compiler was stopped: it used too much {}\n", name_of(outcome.limit));
    fs::remove(out / name);
    write_file(out / "log", log);
  }
  // What a limit ended may have been the machine's fault: another run of the grader tries it again.
  if (outcome.limit == Limit::none) {
    std::error_code exists;
    fs::create_directories(kept.parent_path());
    fs::rename(out, kept, exists);
  } else if (seconds == kWallSeconds) {
    own.stopped = log;
  }
  fs::remove_all(work);
  return {done ? kept / name : fs::path(), key, log};
}

std::string Workshop::link(const Recipe& recipe, const std::string& program,
                           const std::map<std::string, Object>& objects, const fs::path& to) {
  const fs::path out = new_folder("link");
  Words command = recipe.link;
  std::vector<fs::path> folders;
  for (const auto& [path, object] : objects) {
    Words compiled = recipe.compile.at(path);
    const std::string own = after(compiled, "-o");
    const auto place = std::ranges::find(command, own);
    if (place == command.end())
      throw Error::failed(fmt::format("does not find '{}' among what '{}' links", own, program));
    *place = object.file.string();
    folders.push_back(object.file.parent_path());
  }
  after(command, "-o") = (out / program).string();
  const Outcome outcome = run(command, folders, out, kWallSeconds);
  std::string log;
  if (!outcome.succeeded() || !fs::is_regular_file(out / program)) {
    log = readable_log(outcome.errors, cache_ / "objects", tree_.source);
    if (log.empty()) log = "the linker made no program\n";
  } else {
    std::error_code exists;
    const fs::path alone = out / "program";
    fs::create_directories(alone);
    fs::rename(out / program, alone / program);
    fs::permissions(alone / program, fs::perms(0755));
    fs::create_directories(to.parent_path());
    fs::rename(alone, to, exists);
  }
  fs::remove_all(out);
  return log;
}

Program Workshop::make(const std::string& program, const std::map<std::string, std::string>& files,
                       TimeBudget* budget) {
  const Recipe& how = recipe(program);
  Program made;
  std::map<std::string, Object> objects;
  std::string keys;
  for (const auto& [path, text] : files) {
    if (how.compile.count(path) == 0 || text == read_file(tree_.source / path)) continue;
    Object object = compile(how, path, text, budget);
    if (object.file.empty()) {
      made.refused.push_back({path, object.log});
      continue;
    }
    keys += object.key;
    objects.emplace(path, std::move(object));
  }
  const fs::path kept =
      cache_ / "programs" /
      fingerprint({tree_.fingerprint, program, fmt::format("{}", fmt::join(how.link, "\n")), keys});
  made.file = kept / program;
  if (is_cached(kept)) return made;
  const std::string log = link(how, program, objects, kept);
  if (log.empty()) return made;
  if (objects.empty())
    throw Error::failed(fmt::format("the course's own '{}' does not link", program), {}, log);
  // Those that link without the others stay.
  std::map<std::string, std::string> sound;
  std::vector<store::CompilerLog> refused;
  for (const auto& [path, object] : objects) {
    std::vector<store::CompilerLog> alone = {{path, log}};
    if (objects.size() > 1) alone = make(program, {{path, files.at(path)}}, budget).refused;
    if (alone.empty())
      sound[path] = files.at(path);
    else
      refused.push_back(alone.front());
  }
  if (refused.empty()) {
    for (const auto& [path, text] : sound) refused.push_back({path, log});
    sound.clear();
  }
  const Program rest = make(program, sound, budget);
  made.file = rest.file;
  made.refused.insert(made.refused.end(), refused.begin(), refused.end());
  made.refused.insert(made.refused.end(), rest.refused.begin(), rest.refused.end());
  return made;
}

BuiltTree starter_tree(const fs::path& course, const fs::path& cache) {
  fs::create_directories(cache);
  const Descriptor lock = lock_file(cache / "lock");
  std::vector<material::StarterFile> files = material::starter_files(course);
  std::erase_if(files, [](const material::StarterFile& file) { return is_for_people(file.path); });
  std::string print = fingerprint({output_of({"c++", "--version"}, cache, 60), cache.string()});
  for (const material::StarterFile& file : files)
    print = fingerprint({print, file.path, file.text ? *file.text : read_file(file.source)});
  BuiltTree tree{cache / ("starter-" + print.substr(0, 16)), {}, print};
  tree.build = tree.source / "build/release";
  if (is_cached(tree.source) && fs::exists(tree.build / "is-built")) return tree;
  fs::remove_all(tree.source);
  material::write_files(files, tree.source);
  output_of({"cmake", "--preset", "release"}, tree.source, 300);
  output_of({"ninja", "-C", "build/release", "labs/all"}, tree.source, 3600);
  write_file(tree.build / "is-built", "");
  return tree;
}

BuiltTree solution_tree(const fs::path& course, const fs::path& build, const BuiltTree& starter) {
  const auto is_code = [](const fs::path& file) {
    return file.extension() == ".cpp" || file.extension() == ".hpp" || file.extension() == ".txt";
  };
  return {course, build,
          fingerprint({fingerprint_of_folder(course / "labs", is_code),
                       fingerprint_of_folder(course / "common", is_code), starter.fingerprint})};
}

}  // namespace texel::grade
