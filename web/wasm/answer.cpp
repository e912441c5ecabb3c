// The one function that a page calls.
#include <string>

#include <taut/web/session.h>

/// Text in, text out, which is kept until the next question.
extern "C" const char* taut_answer(const char* request) {
  static taut::web::Session session;
  static std::string answer;
  answer = session.answer(request);
  return answer.c_str();
}
