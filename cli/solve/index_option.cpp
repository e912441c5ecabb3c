#include <taut/cli/solve/index_option.h>

#include <fmt/format.h>

#include <taut/cli/options.h>
#include <taut/cli/progress.h>
#include <taut/io/results/words.h>
#include <taut/io/saved/index_file.h>

namespace taut::cli {

void add_index_options(CommandLine& app, IndexOptions& options) {
  app.add_flag("--index", options.build, "Build an index first: then a query takes microseconds. For thousands of them")
      .group("Index");
  app.add_option_function(
         "--index-memory", [&options](const std::string& text) { options.memory = memory_of(text); },
         "How large it may become (default: 64M); the smaller, the longer queries take")
      .type_name("SIZE")
      .group("Index");
  app.add_option("--save-index", options.save, "Build it and keep it for --load-index")
      .type_name("FILE")
      .group("Index");
  app.add_option("--load-index", options.load, "Take it from here instead of building it: it is mapped, not read")
      .type_name("FILE")
      .group("Index");
  app.callback([&options] {
    if (!options.save.empty()) options.build = true;
    if (options.build && !options.load.empty())
      throw UsageError("--load-index makes no sense with --index or --save-index");
  });
}

std::optional<Index> index_of(const IndexOptions& options, const FreeSpace& space, Run& run) {
  if (!options.wanted()) return std::nullopt;
  return run.stage("index", [&] {
    return options.load.empty() ? Index(space, options.memory, shown_progress(run.options()))
                                : load_index(options.load, space);
  });
}

void add_index(const IndexOptions& options, const Index& index, Answer& answer) {
  answer.result["index"] = Json{{"bends", index.bend_count()}, {"bytes", index.bytes().size()}};
  answer.stats.emplace_back("index", fmt::format("index, {}, {:.3g} MB", count_text(index.bend_count(), "bend"),
                                                 static_cast<double>(index.bytes().size()) / 1e6));
  if (!options.save.empty()) answer.files.push_back({options.save, index_file(index)});
}

}  // namespace taut::cli
