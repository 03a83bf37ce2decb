let reason path message =
  let prefix = path ^ ": " in
  let k = String.length prefix in
  if String.length message > k && String.equal (String.sub message 0 k) prefix then
    String.sub message k (String.length message - k)
  else message
