#include "suite/workers/channel.h"

#include <array>
#include <cerrno>
#include <cstring>

#include <sys/socket.h>
#include <unistd.h>

namespace refraster::suite {
namespace {

using Length = std::uint64_t; // both sides are one program

bool send_all(int socket, const void* from, std::size_t size_bytes) {
  const char* at = static_cast<const char*>(from);
  while (size_bytes > 0) {
    const ssize_t sent = send(socket, at, size_bytes, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    at += sent;
    size_bytes -= static_cast<std::size_t>(sent);
  }
  return true;
}

bool receive_all(int socket, void* to, std::size_t size_bytes) {
  char* at = static_cast<char*>(to);
  while (size_bytes > 0) {
    const ssize_t got = recv(socket, at, size_bytes, 0);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    at += got;
    size_bytes -= static_cast<std::size_t>(got);
  }
  return true;
}

} // namespace

bool send_message(int socket, std::string_view bytes) {
  const Length length = bytes.size();
  return send_all(socket, &length, sizeof length) && send_all(socket, bytes.data(), bytes.size());
}

std::optional<std::string> receive_message(int socket) {
  Length length = 0;
  if (!receive_all(socket, &length, sizeof length)) return std::nullopt;
  std::string bytes(length, '\0');
  if (!receive_all(socket, bytes.data(), bytes.size())) return std::nullopt;
  return bytes;
}

MessageReader::Channel MessageReader::read_from(int socket) {
  std::array<char, 1 << 16> piece;
  while (true) {
    const ssize_t got = recv(socket, piece.data(), piece.size(), MSG_DONTWAIT);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return errno == EAGAIN || errno == EWOULDBLOCK ? Channel::open : Channel::closed;
    if (got == 0) return Channel::closed;
    bytes_.append(piece.data(), static_cast<std::size_t>(got));
  }
}

std::optional<std::string> MessageReader::next() {
  Length length = 0;
  if (bytes_.size() < sizeof length) return std::nullopt;
  std::memcpy(&length, bytes_.data(), sizeof length);
  if (bytes_.size() - sizeof length < length) return std::nullopt;
  std::string message = bytes_.substr(sizeof length, length);
  bytes_.erase(0, sizeof length + length);
  return message;
}

} // namespace refraster::suite
