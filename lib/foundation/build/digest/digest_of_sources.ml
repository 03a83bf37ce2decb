(* A digest of what a program is built from: the versions before "--" and the files after it. *)

let () =
  let rec cut before = function
    | "--" :: files -> (List.rev before, files)
    | word :: rest -> cut (word :: before) rest
    | [] -> failwith "usage: digest_of_sources VERSION… -- FILE…"
  in
  let versions, files = cut [] (List.tl (Array.to_list Sys.argv)) in
  let of_file path = Printf.sprintf "%s %s" (Digest.to_hex (Digest.file path)) path in
  let all = versions @ List.map of_file (List.sort String.compare files) in
  Printf.printf "let digest = %S\n" (Digest.to_hex (Digest.string (String.concat "\n" all)))
