let for_text s =
  let b = Buffer.create (String.length s) in
  let add = function
    | '<' -> Buffer.add_string b "&lt;"
    | '>' -> Buffer.add_string b "&gt;"
    | '&' -> Buffer.add_string b "&amp;"
    | c -> Buffer.add_char b c
  in
  String.iter add s;
  Buffer.contents b

(* In JSON this sign stands in strings alone. *)
let for_data s =
  if not (String.contains s '<') then s
  else String.concat "\\u003c" (String.split_on_char '<' s)

let hash text = Printf.sprintf "'sha256-%s'" (Base64.encode_string (Sha256.to_bin (Sha256.string text)))

(* Scripts are told by their hashes, so that nothing that slips in is run. *)
let policy =
  lazy
    (let hashes texts = String.concat " " (List.map hash texts) in
     Printf.sprintf
       "default-src 'none'; script-src %s; style-src %s; img-src data: blob:; base-uri 'none'; form-action 'none'"
       (hashes (List.map snd Assets.scripts))
       (hash Assets.style))

let element name attributes text = Printf.sprintf "<%s%s>%s</%s>\n" name attributes text name

(* The template says where each of these goes, by a line of its own. *)
let write ~title data put =
  let line = function
    | "@policy@" ->
      put
        (Printf.sprintf "<meta http-equiv=\"Content-Security-Policy\" content=\"%s\">\n" (Lazy.force policy))
    | "@title@" -> put (element "title" "" (for_text title))
    | "@style@" -> put (element "style" "" Assets.style)
    | "@data@" ->
      put "<script type=\"application/json\" id=\"data\">";
      data (fun s -> put (for_data s));
      put "</script>\n"
    | "@scripts@" -> List.iter (fun (_, text) -> put (element "script" "" text)) Assets.scripts
    | text -> put (text ^ "\n")
  in
  List.iter line (String.split_on_char '\n' Assets.page)
