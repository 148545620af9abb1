#include "tests/support/player_double.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <deque>
#include <map>
#include <mutex>
#include <thread>
#include <utility>

namespace ccmorse::test {

namespace wire = ccmorse::wire::player;

struct PlayerDouble::Impl {
  struct Client {
    int handle = -1;
    wire::FrameReader reader;
    bool pull = false;
    bool asked = false;    // for a round
    std::size_t sent = 0;  // of the round
    std::deque<Noted> queue;
  };

  std::vector<Device> devices;
  int listener = -1;
  int wake = -1;
  std::uint16_t port = 0;
  mutable std::mutex mutex;
  mutable std::condition_variable changed;
  std::vector<Client> clients;
  std::vector<Noted> noted;
  std::map<std::pair<std::uint16_t, std::uint8_t>, wire::Bytes> answers;
  std::map<std::pair<std::uint16_t, std::uint16_t>, int> subscribed;
  std::deque<Noted> early;  // data before any client came
  std::uint32_t dropped = 0;
  bool agree = false;
  bool silent = false;
  bool stop = false;
  std::thread thread;

  explicit Impl(std::vector<Device> d) : devices(std::move(d)) {
    listener = ::socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    auto* any = reinterpret_cast<sockaddr*>(&address);
    if (::bind(listener, any, size) != 0 || ::listen(listener, 8) != 0) std::abort();
    ::getsockname(listener, any, &size);
    port = ntohs(address.sin_port);
    wake = ::eventfd(0, EFD_NONBLOCK);
    thread = std::thread([this] { Run(); });
  }

  void Wake() const {
    const std::uint64_t one = 1;
    if (::write(wake, &one, sizeof one) < 0) std::abort();
  }

  void Run() {
    while (true) {
      std::vector<pollfd> fds = {{listener, POLLIN, 0}, {wake, POLLIN, 0}};
      {
        const std::lock_guard lock(mutex);
        if (stop) return;
        for (const Client& client : clients) fds.push_back({client.handle, POLLIN, 0});
      }
      ::poll(fds.data(), fds.size(), -1);
      const std::lock_guard lock(mutex);
      std::uint64_t count = 0;
      while (::read(wake, &count, sizeof count) > 0) {
      }
      for (std::size_t i = 2; i < fds.size(); ++i) {
        if (fds[i].revents == 0) continue;
        const auto client = std::find_if(clients.begin(), clients.end(), [&](const Client& each) {
          return each.handle == fds[i].fd;
        });
        if (client != clients.end() && !Receive(*client)) {
          ::close(client->handle);
          clients.erase(client);
        }
      }
      if ((fds[0].revents & POLLIN) != 0) Accept();
      for (Client& client : clients) Deliver(client);
      changed.notify_all();
    }
  }

  void Accept() {
    Client& client = clients.emplace_back();
    client.handle = ::accept(listener, nullptr, nullptr);
    const int on = 1;
    ::setsockopt(client.handle, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    client.queue = std::exchange(early, {});
    Send(client, wire::Banner("3.1.0-test"));
  }

  static void Send(const Client& client, const std::string& bytes) {
    ::send(client.handle, bytes.data(), bytes.size(), MSG_NOSIGNAL);
  }

  static void Send(const Client& client, wire::Header header, wire::MessageType type,
                   const wire::Bytes& body = {}) {
    header.type = type;
    std::string bytes;
    wire::Append(header, body, bytes);
    Send(client, bytes);
  }

  bool Receive(Client& client) {
    std::array<char, 4096> block;
    const ssize_t size = ::recv(client.handle, block.data(), block.size(), 0);
    if (size <= 0) return false;
    client.reader.Append({block.data(), static_cast<std::size_t>(size)});
    while (const auto message = client.reader.Next()) {
      noted.push_back({message->header, {message->body.begin(), message->body.end()}});
      if (message->header.type == wire::MessageType::kRequest) Reply(client, noted.back());
    }
    return true;
  }

  const Device* Find(const wire::Devaddr& address) const {
    const auto found = std::find_if(devices.begin(), devices.end(), [&](const Device& each) {
      return each.interf == address.interf && each.index == address.index;
    });
    return found == devices.end() ? nullptr : &*found;
  }

  void Reply(Client& client, const Noted& request) {
    using Type = wire::MessageType;
    const wire::Header& header = request.header;
    if (header.address.interf != wire::kPlayer) {
      if (silent) return;
      const auto answer = answers.find({header.address.interf, header.subtype});
      if (answer != answers.end()) {
        Send(client, header, Type::kAck, answer->second);
      } else {
        Send(client, header, agree ? Type::kAck : Type::kNack);
      }
      return;
    }
    switch (header.subtype) {
      case wire::kPlayerReqDevlist: {
        wire::DeviceDevlist list;
        for (const Device& each : devices) list.devices.push_back({0, 0, each.interf, each.index});
        Send(client, header, Type::kAck, wire::Encode(list));
        return;
      }
      case wire::kPlayerReqDriverinfo: {
        wire::DeviceDriverinfo info;
        if (!wire::Decode(request.body, info) || Find(info.addr) == nullptr) break;
        info.driver_name = Find(info.addr)->driver;
        Send(client, header, Type::kAck, wire::Encode(info));
        return;
      }
      case wire::kPlayerReqDev: {
        wire::DeviceReq device;
        if (!wire::Decode(request.body, device) || Find(device.addr) == nullptr) break;
        subscribed[{device.addr.interf, device.addr.index}] += device.access == 1 ? 1 : -1;
        device.driver_name = Find(device.addr)->driver;
        Send(client, header, Type::kAck, wire::Encode(device));
        return;
      }
      case wire::kPlayerReqData:
        client.asked = true;
        client.sent = 0;
        Send(client, header, Type::kAck);
        return;
      case wire::kPlayerReqDatamode: {
        wire::DeviceDatamodeReq mode;
        if (!wire::Decode(request.body, mode)) break;
        client.pull = mode.mode == 2;
        Send(client, header, Type::kAck);
        return;
      }
      case wire::kPlayerReqAddReplaceRule:
        Send(client, header, Type::kAck);
        return;
      default:
        break;
    }
    Send(client, header, wire::MessageType::kNack);
  }

  void Deliver(Client& client) {
    if (client.pull && !client.asked) return;
    for (; !client.queue.empty(); client.queue.pop_front()) {
      Send(client, client.queue.front().header, wire::MessageType::kData,
           client.queue.front().body);
      ++client.sent;
    }
    if (!client.pull || client.sent == 0) return;
    client.asked = false;
    wire::Header synch;
    synch.address.interf = wire::kPlayer;
    synch.subtype = dropped > 0 ? 2 : 1;
    Send(client, synch, wire::MessageType::kSynch,
         dropped > 0 ? wire::Encode(wire::Overflow{std::exchange(dropped, 0)}) : wire::Bytes());
  }
};

PlayerDouble::PlayerDouble(std::vector<Device> devices)
    : impl_(std::make_unique<Impl>(std::move(devices))) {}

PlayerDouble::~PlayerDouble() {
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->stop = true;
  }
  impl_->Wake();
  impl_->thread.join();
  for (const Impl::Client& client : impl_->clients) ::close(client.handle);
  ::close(impl_->listener);
  ::close(impl_->wake);
}

std::uint16_t PlayerDouble::port() const { return impl_->port; }

void PlayerDouble::Queue(std::uint16_t interf, std::uint16_t index, std::uint8_t subtype,
                         double time, wire::Bytes body) {
  Noted message;
  message.header.address = {0, 0, interf, index};
  message.header.subtype = subtype;
  message.header.time = time;
  message.body = std::move(body);
  {
    const std::lock_guard lock(impl_->mutex);
    if (impl_->clients.empty()) impl_->early.push_back(message);
    for (Impl::Client& client : impl_->clients) client.queue.push_back(message);
  }
  impl_->Wake();
}

void PlayerDouble::Overflow(std::uint32_t count) {
  const std::lock_guard lock(impl_->mutex);
  impl_->dropped = count;
}

void PlayerDouble::AnswerBytes(std::uint16_t interf, std::uint8_t subtype, wire::Bytes body) {
  const std::lock_guard lock(impl_->mutex);
  impl_->answers[{interf, subtype}] = std::move(body);
}

void PlayerDouble::AgreeToAll() {
  const std::lock_guard lock(impl_->mutex);
  impl_->agree = true;
}

void PlayerDouble::FallSilent() {
  const std::lock_guard lock(impl_->mutex);
  impl_->silent = true;
}

void PlayerDouble::Disconnect() {
  const std::lock_guard lock(impl_->mutex);
  for (const Impl::Client& client : impl_->clients) ::shutdown(client.handle, SHUT_RDWR);
}

std::vector<PlayerDouble::Noted> PlayerDouble::Messages() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->noted;
}

std::size_t PlayerDouble::Count(std::uint16_t interf, wire::MessageType type,
                                std::uint8_t subtype) const {
  const std::lock_guard lock(impl_->mutex);
  return static_cast<std::size_t>(
      std::count_if(impl_->noted.begin(), impl_->noted.end(), [&](const Noted& each) {
        return each.header.address.interf == interf && each.header.type == type &&
               each.header.subtype == subtype;
      }));
}

bool PlayerDouble::WaitFor(std::uint16_t interf, wire::MessageType type, std::uint8_t subtype,
                           std::size_t count) const {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  while (Count(interf, type, subtype) < count) {
    std::unique_lock lock(impl_->mutex);
    if (impl_->changed.wait_until(lock, std::min(deadline, std::chrono::steady_clock::now() +
                                                               std::chrono::milliseconds(20))) ==
            std::cv_status::timeout &&
        std::chrono::steady_clock::now() >= deadline) {
      return false;
    }
  }
  return true;
}

std::size_t PlayerDouble::Subscribed() const {
  const std::lock_guard lock(impl_->mutex);
  return static_cast<std::size_t>(std::count_if(impl_->subscribed.begin(), impl_->subscribed.end(),
                                                [](const auto& each) { return each.second > 0; }));
}

}  // namespace ccmorse::test
