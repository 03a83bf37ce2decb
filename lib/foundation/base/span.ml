type t = { file : string; start : int; stop : int }

let make ~file ~start ~stop = { file; start; stop = max start stop }

let of_file file = make ~file ~start:0 ~stop:0

let merge a b =
  { a with start = min a.start b.start; stop = max a.stop b.stop }

let none = { file = ""; start = 0; stop = 0 }
let is_none s = String.equal s.file "" && s.start = 0 && s.stop = 0

let command_line = { none with file = "command line" }

let equal a b =
  String.equal a.file b.file && a.start = b.start && a.stop = b.stop
