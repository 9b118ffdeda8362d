#include "tests/architecture/target_graph.hpp"

#include <filesystem>
#include <regex>

namespace farrier::architecture {
namespace {

std::string without_comments(const Source& cmake) {
  std::string text;
  for (const std::string& line : cmake.lines) {
    text += line.substr(0, line.find('#')) + '\n';
  }
  return text;
}

std::vector<std::string> words(const std::string& text) {
  static const std::regex word(R"re("[^"]*"|[^\s"]+)re");
  return {std::sregex_token_iterator(text.begin(), text.end(), word), {}};
}

std::string folder_of(const std::string& path) {
  const auto slash = path.rfind('/');
  return slash == std::string::npos ? "" : path.substr(0, slash);
}

bool includes(const Source* source, const std::string& path) {
  if (source == nullptr) {
    return false;
  }
  for (const Include& include : includes_of(*source)) {
    if (include.quoted && (include.target == path || "lib/" + include.target == path)) {
      return true;
    }
  }
  return false;
}

std::string header_of(std::string path) { return path.replace(path.rfind('.'), std::string::npos, ".hpp"); }

bool is_keyword(const std::string& word) {
  return word == "PUBLIC" || word == "PRIVATE" || word == "INTERFACE" || word == "STATIC" || word == "SHARED" ||
         word == "OBJECT" || word == "RUNS_PROCESSES";
}

/// Words for which an argument stands in a loop over FARRIER_PROCESSES: the argument itself if it names no process.
std::vector<std::string> of_each_process(const std::string& argument) {
  static const std::string kVariable = "${process}";
  const std::size_t place = argument.find(kVariable);
  if (place == std::string::npos) {
    return {argument};
  }
  std::vector<std::string> expanded;
  for (const std::string& process : processes()) {
    expanded.push_back(std::string(argument).replace(place, kVariable.size(), process));
  }
  return expanded;
}

}  // namespace

TargetGraph::TargetGraph(const std::vector<const Source*>& cmake_files) {
  // Commands without parentheses among their arguments, which is all that declare targets.
  static const std::regex command(R"re(([A-Za-z_]+)\s*\(([^()]*)\))re");
  for (const Source* cmake : cmake_files) {
    const std::string text = without_comments(*cmake);
    for (std::sregex_iterator match(text.begin(), text.end(), command), end; match != end; ++match) {
      run((*match)[1], words((*match)[2]), folder_of(cmake->path));
    }
  }
}

const TargetGraph& TargetGraph::of_product() {
  static const TargetGraph graph([] {
    std::vector<const Source*> files;
    for (const Source& source : source_tree()) {
      if (source.path.ends_with("CMakeLists.txt") && !source.in("tests")) {
        files.push_back(&source);
      }
    }
    return files;
  }());
  return graph;
}

void TargetGraph::run(const std::string& command, const std::vector<std::string>& arguments,
                      const std::string& folder) {
  if (arguments.empty()) {
    return;
  }
  const bool ours = command == "farrier_library";
  const bool program = command == "farrier_program";
  if (ours || program || command == "add_library" || command == "add_executable" || command == "target_sources") {
    const char* const prefix = ours ? "farrier_" : program && arguments[0] != "farrier" ? "farrier_program_" : "";
    const std::string name = prefix + arguments[0];
    Target& target = targets_[name];
    if (target.name.empty()) {
      target.name = name;
      target.folder = folder;
      if (command != "add_library") {  // those are generated or imported code
        of_folder_[folder].push_back(name);
      }
    }
    for (std::size_t i = 1; i < arguments.size(); ++i) {
      if (!is_keyword(arguments[i])) {
        target.sources.insert(folder + "/" + arguments[i]);
      }
    }
  } else if (command == "farrier_plain_process") {
    targets_[arguments[0]] = {.name = arguments[0], .folder = folder, .sources = {}, .links = {}, .passed_on = {}};
    run("target_link_libraries", {arguments[0], "PRIVATE", "farrier_" + arguments[0] + "_app", "farrier_process"},
        folder);
  } else if (command == "target_link_libraries") {
    Target& target = targets_[arguments[0]];
    bool passes_on = true;  // as CMake: no keyword is PUBLIC
    for (std::size_t i = 1; i < arguments.size(); ++i) {
      if (is_keyword(arguments[i])) {
        passes_on = arguments[i] != "PRIVATE";
        continue;
      }
      for (const std::string& link : of_each_process(arguments[i])) {
        target.links.insert(link);
        if (passes_on) {
          target.passed_on.insert(link);
        }
      }
    }
  }
}

const Target* TargetGraph::owner(const std::string& path) const {
  std::string body = path;
  if (body.ends_with(".hpp")) {
    body.replace(body.size() - 4, 4, ".cpp");
  }
  for (const auto& [name, target] : targets_) {
    if (target.sources.count(body) > 0) {
      return &target;
    }
  }
  std::string folder = folder_of(path);
  while (!folder.empty() && of_folder_.count(folder) == 0) {
    folder = folder_of(folder);
  }
  if (folder.empty()) {
    return nullptr;
  }
  const auto& candidates = of_folder_.at(folder);
  for (const std::string& name : candidates) {
    for (const std::string& source : targets_.at(name).sources) {
      if (source.find('$') != std::string::npos) {
        continue;  // written at build time
      }
      if (includes(find_source(source), path) || includes(find_source(header_of(source)), path)) {
        return &targets_.at(name);
      }
    }
  }
  return &targets_.at(candidates.front());
}

std::set<std::string> TargetGraph::visible(const std::string& name) const {
  std::set<std::string> seen{name};
  std::vector<std::string> open;
  if (const auto target = targets_.find(name); target != targets_.end()) {
    open.assign(target->second.links.begin(), target->second.links.end());
  }
  while (!open.empty()) {
    const std::string next = open.back();
    open.pop_back();
    const auto target = targets_.find(next);
    if (seen.insert(next).second && target != targets_.end()) {
      open.insert(open.end(), target->second.passed_on.begin(), target->second.passed_on.end());
    }
  }
  return seen;
}

std::set<std::string> TargetGraph::reachable(const std::string& name) const {
  std::set<std::string> seen;
  std::vector<std::string> open{name};
  while (!open.empty()) {
    const std::string next = open.back();
    open.pop_back();
    const auto target = targets_.find(next);
    if (seen.insert(next).second && target != targets_.end()) {
      open.insert(open.end(), target->second.links.begin(), target->second.links.end());
    }
  }
  return seen;
}

}  // namespace farrier::architecture
