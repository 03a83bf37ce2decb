let for_text s =
  let b = Buffer.create (String.length s) in
  let add = function '"' -> Buffer.add_char b '"' | c -> Scc_base.Markup.add b c in
  String.iter add s;
  Buffer.contents b

(* In JSON this sign stands in strings alone. *)
let for_data s =
  if not (String.contains s '<') then s
  else String.concat "\\u003c" (String.split_on_char '<' s)

let hash text = Printf.sprintf "'sha256-%s'" (Base64.encode_string (Sha256.to_bin (Sha256.string text)))

(* Scripts and styles are told by their hashes, so that nothing that slips in is run. *)
let policy ~scripts ~styles ~more =
  let hashes texts = String.concat " " (List.map hash texts) in
  Printf.sprintf
    "default-src 'none'; script-src %s; style-src %s; img-src data: blob:; base-uri 'none'; form-action 'none'%s"
    (hashes (List.map snd scripts)) (hashes styles) more

let element name attributes text = Printf.sprintf "<%s%s>%s</%s>\n" name attributes text name

(* What stands before all else of a page from disk, and looks whether it is whole. *)
let first = ("whole.js", Assets.whole)

(* A template says where each of these goes, by a line of its own. *)
let fill template ~title ~policy ~meta ~styles ~scripts data put =
  let line = function
    | "@policy@" ->
      put (Printf.sprintf "<meta http-equiv=\"Content-Security-Policy\" content=\"%s\">\n%s" policy meta)
    | "@first@" -> put (element "script" "" (snd first))
    | "@title@" -> put (element "title" "" (for_text title))
    | "@style@" -> List.iter (fun text -> put (element "style" "" text)) styles
    | "@data@" ->
      put "<script type=\"application/json\" id=\"data\">";
      data (fun s -> put (for_data s));
      put "</script>\n"
    | "@scripts@" -> List.iter (fun (_, text) -> put (element "script" "" text)) scripts
    | text -> put (text ^ "\n")
  in
  List.iter line (String.split_on_char '\n' template)

let own_server = "; connect-src 'self'"
let live = "<meta name=\"scc-live\" content=\"ask\">\n"

let write ?(served = false) ~title data put =
  let styles = [ Assets.style ] and scripts = Assets.scripts in
  (* The state graph is laid out in a worker, of which the text is that of a script of the page. *)
  let more = "; worker-src blob:" ^ if served then own_server else "" in
  let policy = policy ~scripts:(first :: scripts) ~styles ~more in
  fill Assets.page ~title ~policy ~meta:(if served then live else "") ~styles ~scripts data put

let solid ~title data put =
  let styles = [ Assets.solid_style ] and scripts = Assets.solid_scripts in
  let policy = policy ~scripts:(first :: scripts) ~styles ~more:"" in
  fill Assets.solid ~title ~policy ~meta:"" ~styles ~scripts data put

let desk ~title data put =
  let styles = Assets.desk_styles and scripts = Assets.desk_scripts in
  let policy = policy ~scripts ~styles ~more:(own_server ^ "; frame-src 'self'") in
  fill Assets.desk ~title ~policy ~meta:"" ~styles ~scripts data put
