#include <httplib.h>

#include <fmt/format.h>

#include <sys/random.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <stdexcept>

#include <taut/cli/view/page_server.h>

namespace taut::cli {

namespace {

constexpr const char* kHost = "127.0.0.1";
constexpr std::size_t kThreads = 4;  // a browser keeps some connections open that ask nothing
constexpr std::size_t kLongestQuestion = std::size_t{256} << 20;

std::string drawn_token() {
  std::array<std::uint64_t, 2> words{};
  if (getrandom(words.data(), sizeof words, 0) != sizeof words) throw std::runtime_error("no random numbers to be had");
  return fmt::format("{:016x}{:016x}", words[0], words[1]);
}

class PageServer {
 public:
  explicit PageServer(const PageServing& serving) : serving_(serving) {
    server_.new_task_queue = [this] { return new Pool(*this); };
    server_.set_tcp_nodelay(true);  // else an answer waits 40 ms for the acknowledgement of its head
    server_.set_idle_interval(0, 50'000);
    server_.set_keep_alive_timeout(1);
    server_.set_payload_max_length(kLongestQuestion);
    server_.set_pre_routing_handler(
        [this](const httplib::Request& request, httplib::Response& response) { return admitted(request, response); });
  }

  std::size_t serve() {
    port_ = server_.bind_to_any_port(kHost);
    if (port_ <= 0) throw std::runtime_error("no port to be had on the loopback device");
    const std::string root = "/" + drawn_token() + "/";
    server_.Get(root, [this, text = serving_.page(root + "ask")](const httplib::Request&, httplib::Response& response) {
      response.set_header("Cache-Control", "no-store");
      response.set_header("Referrer-Policy", "no-referrer");
      response.set_content(text, "text/html; charset=utf-8");
    });
    server_.Post(root + "ask", [this](const httplib::Request& request, httplib::Response& response) {
      const std::lock_guard lock(mutex_);
      ++answered_;
      response.set_content(serving_.answer(request.body), "application/json");
    });
    serving_.when_ended([this] { over_ = true; });
    serving_.begun(fmt::format("http://{}:{}{}", kHost, port_, root));
    server_.listen_after_bind();
    return answered_;
  }

 private:
  using Clock = std::chrono::steady_clock;

  /// Asked by the thread that listens, every 50 ms while nobody comes.
  class Pool : public httplib::ThreadPool {
   public:
    explicit Pool(PageServer& server) : httplib::ThreadPool(kThreads), server_(server) {}
    void on_idle() override { server_.look_at_the_clock(); }

   private:
    PageServer& server_;
  };

  void look_at_the_clock() {
    const std::chrono::duration<double> since = Clock::now() - begun_;
    if (over_ || (serving_.seconds && since.count() > *serving_.seconds)) server_.stop();
  }

  httplib::Server::HandlerResponse admitted(const httplib::Request& request, httplib::Response& response) {
    look_at_the_clock();
    const std::string here = fmt::format("{}:{}", kHost, port_);
    const bool is_own = !request.has_header("Origin") || request.get_header_value("Origin") == "http://" + here;
    if (request.get_header_value("Host") == here && is_own) return httplib::Server::HandlerResponse::Unhandled;
    response.status = 403;
    return httplib::Server::HandlerResponse::Handled;
  }

  const PageServing& serving_;
  httplib::Server server_;
  int port_ = 0;
  std::mutex mutex_;
  std::size_t answered_ = 0;
  std::atomic<bool> over_{false};
  Clock::time_point begun_ = Clock::now();
};

}  // namespace

}  // namespace taut::cli

extern "C" [[gnu::visibility("default")]] std::size_t taut_serve_page(const taut::cli::PageServing& serving) {
  return taut::cli::PageServer(serving).serve();
}
