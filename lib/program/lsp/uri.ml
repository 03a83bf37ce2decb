let hex c =
  match c with
  | '0' .. '9' -> Some (Char.code c - 48)
  | 'a' .. 'f' -> Some (Char.code c - 87)
  | 'A' .. 'F' -> Some (Char.code c - 55)
  | _ -> None

let decoded text =
  let n = String.length text and b = Buffer.create 64 in
  let rec from i =
    if i < n then
      let code =
        if text.[i] = '%' && i + 2 < n then
          match (hex text.[i + 1], hex text.[i + 2]) with Some a, Some b -> Some ((16 * a) + b) | _ -> None
        else None
      in
      match code with
      | Some code ->
        Buffer.add_char b (Char.chr code);
        from (i + 3)
      | None ->
        Buffer.add_char b text.[i];
        from (i + 1)
  in
  from 0;
  Buffer.contents b

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
  let local rest = if String.length rest > 0 && rest.[0] = '/' then Some (normal (decoded rest)) else None in
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
