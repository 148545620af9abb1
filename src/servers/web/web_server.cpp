#include "servers/web/web_server.h"

#include <algorithm>
#include <array>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <cstdlib>
#include <deque>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>
#include <sstream>
#include <utility>

#include "base/error.h"
#include "base/json.h"
#include "servers/net/listener.h"
#include "servers/net/stream_socket.h"
#include "servers/net/warning_limit.h"
#include "servers/web/view_model.h"

namespace ccmorse::servers {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using asio::ip::tcp;
using Clock = std::chrono::steady_clock;

namespace {

constexpr auto kFramePeriod = std::chrono::microseconds(16'000);
constexpr auto kStandingPeriod = std::chrono::milliseconds(100);  // of frames while time stands
constexpr int kMostUnconfirmed = 2;                               // frames
constexpr std::size_t kMostUnsent = 1U << 20;        // bytes of replies, then the viewer is let go
constexpr std::uint64_t kLongestHeader = 16U << 10;  // bytes of a request
constexpr auto kRequestTime = std::chrono::seconds(10);

// By ending; what is not here is not served.
struct Kind {
  std::string_view ending;
  const char* type;
};
constexpr std::array kKinds = {
    Kind{".html", "text/html; charset=utf-8"},
    Kind{".js", "text/javascript; charset=utf-8"},
    Kind{".css", "text/css; charset=utf-8"},
    Kind{".map", "application/json"},
    Kind{".svg", "image/svg+xml"},
    Kind{".png", "image/png"},
    Kind{".webmanifest", "application/json"},
    Kind{".txt", "text/plain; charset=utf-8"},
};

constexpr const char* kNotBuilt =
    "<!doctype html><meta charset=utf-8><title>CCMorse</title>"
    "<body style='font:16px system-ui;max-width:40em;margin:4em auto'>"
    "<h1>The view is not built</h1><p>The simulation runs, but the page that shows it is missing. "
    "Build it with <code>npm ci --prefix web &amp;&amp; npm run build --prefix web</code> and load "
    "this page again.";

}  // namespace

bool IsLoopback(const std::string& host) {
  return host == "localhost" || host == "127.0.0.1" || host == "[::1]" || host == "::1";
}

struct WebServer::Shared : std::enable_shared_from_this<WebServer::Shared> {
  Shared(asio::io_context& io, const sim::Simulation& simulation_in, ServiceDirectory& directory_in,
         WebServerOptions options_in)
      : simulation(&simulation_in),
        directory(&directory_in),
        options(std::move(options_in)),
        model(std::make_unique<ViewModel>(simulation_in)),
        timer(io) {}

  // Simulated seconds per wall-clock second over the last half second.
  double Rate(Clock::time_point now) {
    const double wall = std::chrono::duration<double>(now - rate_since).count();
    if (wall > 0.5) {
      rate = (simulation->time() - rate_from) / wall;
      rate_since = now;
      rate_from = simulation->time();
    }
    return rate;
  }

  // "localhost:8000" of a Host or an Origin's end: is that us? Else a page of another site, or a
  // name that was made to point here, asks.
  bool IsUs(std::string_view host) const {
    const auto colon = host.rfind(':');
    const std::string name(host.substr(0, colon));
    return IsLoopback(name) || name == options.bind || !options.token.empty();
  }

  // Why a viewer may not call a service; "" where it may.
  std::string Refusal(std::string_view component, std::string_view service) const {
    static const std::set<std::string_view> kLooks = {"get_local_data", "get_configurations",
                                                      "get_properties", "get_layers"};
    static const std::set<std::string_view> kOwnLooks = {"time", "log"};
    static const std::set<std::string_view> kTime = {"pause", "resume", "step", "set_speed",
                                                     "seek"};
    const bool own = component == "ccmorse";
    if (own ? kOwnLooks.contains(service) : kLooks.contains(service)) return "";
    if (options.read_only) return "this view is read-only";
    if (options.record && !(own && kTime.contains(service))) {
      return "this is a record: it cannot be changed";
    }
    return "";
  }

  // What the page is told beside the scene.
  Json About() const {
    Json about(Json::Object{{"read_only", options.read_only}, {"record", Json()}});
    if (options.record) {
      about.Set("record",
                Json::Object{{"file", options.record->file}, {"seconds", options.record->seconds}});
    }
    return about;
  }

  // Viewers that have seen the same get the same bytes, which are made once.
  std::shared_ptr<const std::string> Frame(ViewModel::Seen& seen) {
    const TimeState time = directory->time_state();
    const double now = Rate(Clock::now());
    if (sending && last_frame && last_before == seen) {
      seen = last_after;
      return last_frame;
    }
    last_before = seen;
    last_frame = std::make_shared<const std::string>(model->Frame(seen, now, time));
    last_after = seen;
    return last_frame;
  }

  void SendFrames();
  void Tend();

  const sim::Simulation* simulation;
  ServiceDirectory* directory;
  WebServerOptions options;
  std::unique_ptr<ViewModel> model;
  asio::steady_timer timer;
  bool tended = false;  // the timer runs
  std::shared_ptr<Listener> listener;
  std::set<std::shared_ptr<Viewer>> viewers;
  Clock::time_point next_frame;
  Clock::time_point rate_since = Clock::now();
  double rate_from = 0.0;
  double rate = 0.0;
  // The last frame that was made: of a viewer that had seen what, and then has seen what. Good for
  // others within one round of sending only, as services change things at any time.
  bool sending = false;
  ViewModel::Seen last_before;
  ViewModel::Seen last_after;
  std::shared_ptr<const std::string> last_frame;
  WarningLimit warnings;
  bool closed = false;
};

// One browser's WebSocket.
class WebServer::Viewer : public std::enable_shared_from_this<WebServer::Viewer> {
 public:
  Viewer(std::shared_ptr<Shared> shared, beast::tcp_stream stream)
      : shared_(std::move(shared)), socket_(std::move(stream)) {}

  template <typename Request>
  void Accept(const Request& request) {
    beast::get_lowest_layer(socket_).expires_never();
    websocket::stream_base::timeout timeout =
        websocket::stream_base::timeout::suggested(beast::role_type::server);
    socket_.set_option(timeout);
    socket_.auto_fragment(false);  // a frame goes out in one write
    socket_.read_message_max(shared_->options.longest_call);
    socket_.async_accept(request, [self = shared_from_this()](ErrorCode error) {
      if (error || self->shared_->closed) return;
      self->shared_->viewers.insert(self);
      const std::string scene = self->shared_->model->Scene(self->shared_->About());
      self->Send(false, std::make_shared<const std::string>(scene));
      self->shared_->Tend();
      self->SendFrame();
      self->Read();
    });
  }

  bool takes_frames() const { return unconfirmed_ < kMostUnconfirmed; }

  void SendFrame() {
    ++unconfirmed_;
    Send(true, shared_->Frame(seen_));
  }

  // The next frame is of another simulation.
  void Forget() { seen_ = {}; }

  void Close() {
    ErrorCode ignored;
    beast::get_lowest_layer(socket_).socket().close(ignored);
  }

 private:
  void Read() {
    socket_.async_read(buffer_, [self = shared_from_this()](ErrorCode error, std::size_t) {
      if (error) return self->Leave();
      const std::string text = beast::buffers_to_string(self->buffer_.data());
      self->buffer_.clear();
      self->Take(text);
      if (!self->left_) self->Read();
    });
  }

  void Take(const std::string& text) {
    if (text == "k") {  // a frame was shown
      unconfirmed_ = std::max(0, unconfirmed_ - 1);
      return;
    }
    Json id;
    try {
      const Json message = Json::Parse(text);
      if (const Json* found = message.Find("id")) id = *found;
      const Json* call = message.Find("call");
      if (call == nullptr || !call->IsArray() || call->AsArray().size() != 3) {
        return Answer(id, false,
                      Json("expected {\"id\": n, \"call\": [component, service, [..]]}"));
      }
      const Json::Array& parts = call->AsArray();
      const std::string refusal = shared_->Refusal(parts[0].AsString(), parts[1].AsString());
      if (!refusal.empty()) return Answer(id, false, Json(refusal));
      shared_->directory->Call(
          parts[0].AsString(), parts[1].AsString(), parts[2].Dump(),
          [self = weak_from_this(), id](const sim::ServiceResult& result) {
            const auto viewer = self.lock();
            if (!viewer || viewer->left_) return;
            const Json value =
                result.text.empty() ? result.value : Json::Parse(std::string(result.text));
            viewer->Answer(id, result.outcome == sim::Outcome::kSuccess, value);
          });
    } catch (const std::exception& error) {
      Answer(id, false, Json(error.what()));
    }
  }

  void Answer(const Json& id, bool ok, const Json& value) {
    Send(false, std::make_shared<const std::string>(
                    Json(Json::Object{{"id", id}, {"ok", ok}, {"value", value}}).Dump()));
  }

  void Send(bool binary, std::shared_ptr<const std::string> message) {
    unsent_ += message->size();
    // Frames wait for confirmation; replies pile up only where somebody asks and never reads.
    if (!waiting_.empty() && unsent_ > kMostUnsent + waiting_.front().second->size())
      return Leave();
    waiting_.emplace_back(binary, std::move(message));
    if (waiting_.size() == 1) Write();
  }

  void Write() {
    socket_.binary(waiting_.front().first);
    socket_.async_write(asio::buffer(*waiting_.front().second),
                        [self = shared_from_this()](ErrorCode error, std::size_t) {
                          if (error) return self->Leave();
                          self->unsent_ -= self->waiting_.front().second->size();
                          self->waiting_.pop_front();
                          if (!self->waiting_.empty()) self->Write();
                        });
  }

  void Leave() {
    if (std::exchange(left_, true)) return;
    Close();
    shared_->viewers.erase(shared_from_this());
  }

  std::shared_ptr<Shared> shared_;
  websocket::stream<beast::tcp_stream> socket_;
  beast::flat_buffer buffer_;
  std::deque<std::pair<bool, std::shared_ptr<const std::string>>> waiting_;  // binary?, message
  std::size_t unsent_ = 0;                                                   // bytes of waiting_
  ViewModel::Seen seen_;
  int unconfirmed_ = 0;
  bool left_ = false;
};

void WebServer::Shared::SendFrames() {
  if (directory->time_state().jumping) return;
  next_frame = Clock::now() + kFramePeriod;
  const auto all = viewers;  // one may leave while it is sent to
  last_frame = nullptr;
  sending = true;
  for (const auto& viewer : all) {
    if (viewer->takes_frames()) viewer->SendFrame();
  }
  sending = false;
}

// What is changed while time stands still is to be seen, too.
void WebServer::Shared::Tend() {
  if (tended) return;
  tended = true;
  timer.expires_after(kStandingPeriod);
  timer.async_wait([weak = weak_from_this()](ErrorCode error) {
    const auto shared = weak.lock();
    if (error || !shared || shared->closed) return;
    shared->tended = false;
    if (shared->viewers.empty()) return;
    if (Clock::now() > shared->next_frame + kStandingPeriod - kFramePeriod) shared->SendFrames();
    shared->Tend();
  });
}

// One connection that asks for files, until it becomes a viewer.
class WebServer::Session : public std::enable_shared_from_this<WebServer::Session> {
 public:
  Session(std::shared_ptr<Shared> shared, tcp::socket socket)
      : shared_(std::move(shared)), stream_(std::move(socket)) {}

  void Read() {
    parser_.emplace();
    parser_->header_limit(kLongestHeader);
    parser_->body_limit(0);
    stream_.expires_after(kRequestTime);
    http::async_read(stream_, buffer_, *parser_,
                     [self = shared_from_this()](ErrorCode error, std::size_t) {
                       if (error || self->shared_->closed) return;
                       self->Serve();
                     });
  }

 private:
  using Request = http::request<http::string_body>;

  void Serve() {
    const Request& request = parser_->get();
    const auto host = request[http::field::host];
    if (!shared_->IsUs({host.data(), host.size()})) {
      return Reply(http::status::forbidden, "text/plain",
                   "This is not the address that the view is served at.\n");
    }
    const auto target = request.target();
    const std::string_view whole(target.data(), target.size());
    const auto question = whole.find('?');
    const std::string_view path = whole.substr(0, question);
    const std::string_view query =
        question == std::string_view::npos ? "" : whole.substr(question + 1);
    const bool socket = websocket::is_upgrade(request);
    if (!shared_->options.token.empty() && (socket || path == "/") &&
        query != "token=" + shared_->options.token) {
      return Reply(http::status::unauthorized, "text/plain",
                   "The address of this view carries a token; it is printed where the simulation "
                   "was started.\n");
    }
    if (socket) return Upgrade(request);
    if (request.method() != http::verb::get && request.method() != http::verb::head) {
      return Reply(http::status::method_not_allowed, "text/plain", "Only GET.\n");
    }
    ServeFile(path);
  }

  void Upgrade(const Request& request) {
    const auto origin = request[http::field::origin];
    const auto host = request[http::field::host];
    const std::string_view from(origin.data(), origin.size());
    constexpr std::string_view kScheme = "http://";
    // Programs send no Origin; a browser does, and only our own page is answered.
    if (!from.empty() &&
        (!from.starts_with(kScheme) ||
         from.substr(kScheme.size()) != std::string_view(host.data(), host.size()))) {
      shared_->warnings.Warn("a page of {} asked for the view and was refused", from);
      return Reply(http::status::forbidden, "text/plain", "Not from another site.\n");
    }
    if (shared_->viewers.size() >= shared_->options.most_viewers) {
      return Reply(http::status::service_unavailable, "text/plain", "Too many viewers.\n");
    }
    std::make_shared<Viewer>(shared_, std::move(stream_))->Accept(request);
  }

  void ServeFile(std::string_view path) {
    const std::string& folder = shared_->options.folder;
    if (path == "/") {
      if (folder.empty()) return Reply(http::status::ok, kKinds[0].type, kNotBuilt);
      path = "/index.html";
    }
    const auto kind = std::find_if(kKinds.begin(), kKinds.end(),
                                   [&](const Kind& k) { return path.ends_with(k.ending); });
    // One flat folder: a name without a slash cannot lead out of it.
    const bool plain = path.size() > 1 && path.find('/', 1) == std::string_view::npos &&
                       path.find("..") == std::string_view::npos;
    if (plain && kind != kKinds.end() && !folder.empty()) {
      std::ifstream file(folder + std::string(path), std::ios::binary);
      if (file) {
        std::ostringstream content;
        content << file.rdbuf();
        return Reply(http::status::ok, kind->type, content.str());
      }
    }
    Reply(http::status::not_found, "text/plain", "There is no such page here.\n");
  }

  void Reply(http::status status, const char* type, std::string body) {
    auto response =
        std::make_shared<http::response<http::string_body>>(status, parser_->get().version());
    response->set(http::field::content_type, type);
    response->set(http::field::cache_control, "no-cache");
    response->set("X-Content-Type-Options", "nosniff");
    response->set(
        "Content-Security-Policy",
        "default-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; "
        "connect-src 'self' ws:; frame-ancestors 'none'");
    response->keep_alive(parser_->get().keep_alive());
    response->body() = std::move(body);
    response->prepare_payload();
    if (parser_->get().method() == http::verb::head) response->body().clear();
    stream_.expires_after(kRequestTime);
    http::async_write(stream_, *response,
                      [self = shared_from_this(), response](ErrorCode error, std::size_t) {
                        if (error || !response->keep_alive()) return;
                        self->Read();
                      });
  }

  std::shared_ptr<Shared> shared_;
  beast::tcp_stream stream_;
  beast::flat_buffer buffer_;
  std::optional<http::request_parser<http::string_body>> parser_;
};

WebServer::WebServer(asio::io_context& io, const sim::Simulation& simulation,
                     ServiceDirectory& directory, const WebServerOptions& options)
    : shared_(std::make_shared<Shared>(io, simulation, directory, options)) {
  if (!IsLoopback(options.bind) && options.token.empty()) {
    throw Error("the view lets whoever sees it drive the robots: with --bind " + options.bind +
                " give it a --token, too");
  }
  shared_->listener =
      std::make_shared<Listener>(io, [shared = std::weak_ptr(shared_)](tcp::socket socket) {
        const auto alive = shared.lock();
        if (alive) std::make_shared<Session>(alive, std::move(socket))->Read();
      });
  shared_->listener->Open(options.bind, options.port, options.search);
}

WebServer::~WebServer() { Close(); }

int WebServer::port() const { return shared_->listener->port(); }

std::string WebServer::address() const {
  std::string address = "http://" + shared_->options.bind + ":" + std::to_string(port()) + "/";
  if (!shared_->options.token.empty()) address += "?token=" + shared_->options.token;
  return address;
}

void WebServer::Acted() {
  if (shared_->viewers.empty() || Clock::now() < shared_->next_frame) return;
  shared_->SendFrames();
}

void WebServer::Show(const sim::Simulation& simulation, ServiceDirectory& directory) {
  if (shared_->simulation != &simulation) {
    shared_->model = std::make_unique<ViewModel>(simulation);
    for (const auto& viewer : shared_->viewers) viewer->Forget();
  }
  shared_->simulation = &simulation;
  shared_->directory = &directory;
  shared_->rate_since = Clock::now();
  shared_->rate_from = simulation.time();
  if (!shared_->viewers.empty()) shared_->SendFrames();
}

void WebServer::Close() {
  if (std::exchange(shared_->closed, true)) return;
  shared_->listener->Close();
  shared_->timer.cancel();
  const auto viewers = std::exchange(shared_->viewers, {});
  for (const auto& viewer : viewers) viewer->Close();
}

std::string FindWebFolder() {
  namespace fs = std::filesystem;
  std::vector<fs::path> places;
  if (const char* named = std::getenv("CCMORSE_WEB")) places.emplace_back(named);
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  places.push_back(program.parent_path().parent_path() / "share" / "ccmorse" / "web");
  places.emplace_back(CCMORSE_SOURCE_DIR "/web/dist");
  for (const fs::path& place : places) {
    if (fs::exists(place / "index.html", ignored)) return place.string();
  }
  return "";
}

}  // namespace ccmorse::servers
