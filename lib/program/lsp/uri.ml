open Scc_base

let normal path =
  let step kept = function
    | "." | "" -> kept
    | ".." -> (match kept with _ :: rest -> rest | [] -> [])
    | folder -> folder :: kept
  in
  "/" ^ String.concat "/" (List.rev (List.fold_left step [] (String.split_on_char '/' path)))

let after prefix text =
  let n = String.length prefix in
  if String.length text >= n && String.equal (String.lowercase_ascii (String.sub text 0 n)) prefix then
    Some (String.sub text n (String.length text - n))
  else None

let path uri =
  let is_local rest = String.length rest > 0 && rest.[0] = '/' in
  let local rest = if is_local rest then Some (normal (Percent.decoded rest)) else None in
  match (after "file://localhost" uri, after "file://" uri) with
  | Some rest, _ -> local rest
  | None, Some rest -> local rest
  | None, None -> None

let plain c =
  match c with 'a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '-' | '.' | '_' | '~' | '/' -> true | _ -> false

let of_path path =
  let b = Buffer.create 64 in
  Buffer.add_string b "file://";
  String.iter (fun c -> if plain c then Buffer.add_char b c else Printf.bprintf b "%%%02X" (Char.code c)) path;
  Buffer.contents b

let name uri = Option.value (path uri) ~default:uri
