#pragma once
// Messages between two processes, over a socket.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace refraster::suite {

/// Sends all of it, with its length before it. False if nobody reads any more.
bool send_message(int socket, std::string_view bytes);

/// Waits for the next one. Nothing once the other side has closed, or has ended amid a message.
std::optional<std::string> receive_message(int socket);

/// Takes what has come, without waiting, and gives a message once all of it is there: for one who listens to many.
class MessageReader {
public:
  enum class Channel { open, closed };
  /// Reads what is there.
  Channel read_from(int socket);
  std::optional<std::string> next();

private:
  std::string bytes_;
};

} // namespace refraster::suite
