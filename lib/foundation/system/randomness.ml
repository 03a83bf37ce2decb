external fill : Bytes.t -> bool = "scc_random_fill"

let device = "/dev/urandom"

let from_device n =
  try
    let source = open_in_bin device in
    Fun.protect ~finally:(fun () -> close_in_noerr source) (fun () -> Ok (really_input_string source n))
  with
  | Sys_error why -> Error ("the system gives no random bytes: " ^ why)
  | End_of_file -> Error (Printf.sprintf "the system gives no random bytes: %s has ended" device)

let bytes n =
  let buffer = Bytes.create n in
  if fill buffer then Ok (Bytes.to_string buffer) else from_device n
