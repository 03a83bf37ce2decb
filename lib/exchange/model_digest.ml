let make ~text ~files =
  let b = Buffer.create (String.length text) in
  let add name bytes =
    Buffer.add_string b (Printf.sprintf "%d:%s%d:" (String.length name) name (String.length bytes));
    Buffer.add_string b bytes
  in
  add "" text;
  List.iter (fun (name, bytes) -> add name bytes) files;
  "md5:" ^ Digest.to_hex (Digest.string (Buffer.contents b))
