#include <taut/cli/shards.h>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <memory>
#include <utility>

#include <taut/cli/messages.h>
#include <taut/cli/options.h>
#include <taut/cli/output.h>
#include <taut/cli/progress.h>
#include <taut/cli/ranks.h>
#include <taut/geometry/errors.h>
#include <taut/geometry/parallel.h>
#include <taut/io/saved/shard_file.h>
#include <taut/io/worlds/read_world.h>

namespace taut::cli {

namespace {

constexpr std::size_t kMostShards = 1'000'000;

void take_shard(const std::string& text, ShardOptions& options) {
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos) throw UsageError("'" + text + "' is not I/N, as 3/8");
  options.shard = count_of(text.substr(0, slash));
  options.shards = count_of(text.substr(slash + 1));
  if (options.shard < 1 || options.shard > options.shards || options.shards > kMostShards)
    throw UsageError("'" + text + "' is not I/N with I from 1 to N, N up to 1000000");
}

void check(const ShardOptions& options) {
  if (options.ranks && (options.shard > 0 || !options.join.empty()))
    throw UsageError("--mpi goes neither with --shard nor with --join");
  if (options.shard > 0 && !options.join.empty()) throw UsageError("--shard and --join: one or the other");
  if (options.shard > 0 && options.part.empty()) throw UsageError("--shard needs --part FILE, the shard's own");
  if (options.shard == 0 && !options.part.empty()) throw UsageError("--part needs --shard I/N");
}

/// A shard's file: read, then added to. Nobody else writes it meanwhile.
class PartFile {
 public:
  explicit PartFile(const std::string& name)
      : name_(name), file_(::open(name.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
    if (file_ < 0) throw InputError(name, 0, std::string("cannot be written: ") + std::strerror(errno));
    if (::flock(file_, LOCK_EX | LOCK_NB) != 0) throw InputError(name, 0, "another taut is at work on it");
  }
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;
  ~PartFile() { ::close(file_); }

  std::string bytes() const { return read_bytes(name_); }
  void cut(std::size_t size) {
    if (::ftruncate(file_, static_cast<off_t>(size)) != 0 || ::lseek(file_, 0, SEEK_END) < 0) fail();
  }
  void add(std::string_view text) {
    while (!text.empty()) {
      const ssize_t n = ::write(file_, text.data(), text.size());
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) fail();
      text.remove_prefix(static_cast<std::size_t>(n));
    }
  }

 private:
  [[noreturn]] void fail() const { throw WriteError(name_ + ": cannot write: " + std::strerror(errno)); }

  std::string name_;
  int file_;
};

/// Why the file is not a shard of this work; empty when it is.
std::string why_foreign(const ShardHead& head, const ShardHead& own) {
  if (head.command != own.command) return fmt::format("is a shard of taut {}, not of {}", head.command, own.command);
  if (head.work != own.work || head.items != own.items)
    return "is a shard of another work: other inputs, other options or another version";
  if (head.shards != own.shards) return fmt::format("is one of {} shards, not of {}", head.shards, own.shards);
  return {};
}

/// What is there already: items that are whole. A new file gets its head.
std::size_t begin_part(PartFile& part, const std::string& name, const ShardHead& head) {
  const std::string bytes = part.bytes();
  const std::string text = shard_head_text(head);
  if (text.starts_with(bytes) && bytes != text) {  // new, or cut off within its head
    part.cut(0);
    part.add(text);
    return 0;
  }
  const ShardFile file = read_shard_file(bytes, name);
  std::string why = why_foreign(file.head, head);
  if (why.empty() && file.head.shard != head.shard)
    why = fmt::format("is shard {}, not {}", file.head.shard, head.shard);
  if (!why.empty()) throw InputError(name, 0, why);
  part.cut(file.whole);
  return file.items.size();
}

/// Out of the shards' files.
void join_shards(const ShardOptions& options, const std::string& command, const std::string& work, std::size_t count,
                 const std::function<void(std::size_t, std::string_view)>& take) {
  std::vector<std::string> names, bytes;
  std::vector<ShardFile> shards;
  bytes.reserve(options.join.size());
  for (const std::string& name : options.join) {
    bytes.push_back(read_bytes(name));
    ShardFile file = read_shard_file(bytes.back(), name);
    if (shards.empty()) {
      shards.resize(file.head.shards);
      names.resize(file.head.shards);
    }
    const std::string why = why_foreign(file.head, {command, 1, shards.size(), count, work});
    if (!why.empty()) throw InputError(name, 0, why);
    const std::size_t at = file.head.shard - 1;
    if (!names[at].empty()) throw InputError(name, 0, fmt::format("is shard {}, as {} is", at + 1, names[at]));
    if (!file.is_finished)
      throw InputError(name, 0,
                       fmt::format("shard {} of {} {}; --shard {}/{} --part {} goes on with it", at + 1, shards.size(),
                                   file.trouble, at + 1, shards.size(), name));
    names[at] = name;
    shards[at] = std::move(file);
  }
  for (std::size_t i = 0; i < shards.size(); ++i)
    if (names[i].empty()) throw InputError("--join", 0, fmt::format("shard {} of {} is missing", i + 1, shards.size()));
  for (std::size_t item = 0; item < count; ++item) take(item, shards[item % shards.size()].items[item / shards.size()]);
}

}  // namespace

void add_shard_options(CommandLine& app, ShardOptions& options, CommonOptions& common) {
  app.add_option_function(
         "--shard", [&options](const std::string& text) { take_shard(text, options); },
         "Do shard I of N of the work alone, into --part FILE; one that was stopped goes on after what is whole")
      .type_name("I/N")
      .group("Shards");
  app.add_option("--part", options.part, "The shard's own file").type_name("FILE").group("Shards");
  app.add_option("--join", options.join, "Put the files of all N shards together: what one run would have given")
      .type_name("FILE...")
      .group("Shards");
  app.add_flag("--mpi", options.ranks, "Share the work among the processes that mpirun started").group("Shards");
  app.add_option_function(
         "--lost-after", [&options](const std::string& text) { options.lost_after = number_of(text); },
         "Give again what a process is at for so long while another one has nothing to do (default: 300)")
      .type_name("S")
      .group("Shards");
  app.callback([line = app, &options, &common] {
    check(options);
    common.ranks = options.ranks;
    // What changes no result; what is added to this list must not either.
    options.how = line.given_except({"--shard", "--part", "--join", "--mpi", "--lost-after", "--jobs", "--max-seconds",
                                     "--max-memory", "--json", "--stats", "--quiet", "--json-lines", "--output", "--as",
                                     "--svg"});
  });
}

Answer do_shard(const ShardOptions& options, const Items& items, Run& run) {
  const ShardHead head{run.command(), options.shard, options.shards, items.count, items.work};
  PartFile part(options.part);
  const std::size_t there = begin_part(part, options.part, head), all = head.own_items();
  const auto done = std::make_shared<std::atomic<std::size_t>>(there);
  const auto tell = [done, there, head, all, name = options.part]() -> std::pair<Json, std::string> {
    const std::size_t now = *done;
    return {{{"shard", head.shard}, {"shards", head.shards}, {"items", all}, {"done", now}, {"there_before", there}},
            fmt::format("{}: shard {} of {}: {} of {} done{}\n", name, head.shard, head.shards, now,
                        count_text(all, "item"), there > 0 ? fmt::format(", {} of them before", there) : "")};
  };
  run.when_stopped(tell);
  std::vector<std::string> results(all - there);
  const TellProgress show = shown_progress(run.options());
  const auto keep = [&](std::size_t over) {
    for (std::size_t k = *done - there; k < over; ++k) {
      part.add(shard_item_text(head.item(there + k), std::exchange(results[k], {})));
      ++*done;
    }
    if (show) show({"items", *done, all});
  };
  if (!results.empty()) items.prepare();
  if (show) show({"items", there, all});
  each_in_parallel(results.size(), {run.options().limits.jobs, {}, keep}, [&] {
    return [&, work = items.begin()](std::size_t k) { results[k] = work(head.item(there + k)); };
  });
  part.add(shard_end_text());
  auto [json, line] = tell();
  return {.result = std::move(json), .line = std::move(line)};
}

void take_all(const ShardOptions& options, const Items& items, const Run& run,
              const std::function<void(std::size_t, std::string_view)>& take) {
  const TellProgress show = shown_progress(run.options());
  ProgressCount done("items", items.count, show);
  const auto taken = [&](std::size_t item, std::string_view bytes) {
    take(item, bytes);
    done.add();
  };
  if (options.ranks)
    do_by_ranks(items, run.options().limits, options.lost_after, taken);
  else
    join_shards(options, run.command(), items.work, items.count, taken);
}

}  // namespace taut::cli
