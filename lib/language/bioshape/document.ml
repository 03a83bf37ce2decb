open Scc_base
open Scc_syntax

type element = {
  tag : string;
  at : Span.t;
  whole : Span.t;
  attributes : (string * (Span.t * Embedded.t)) list;
  children : element list;
  text : Embedded.t;
}

type t = { root : element; trivia : Trivia.t list }

exception Stop
exception Refused of Diag.t

let max_attributes = 100
let max_nesting = (2 * Tokens.max_nesting) + 10

type reader = {
  source : Source.t;
  text : string;
  namespace : string;
  input : Xmlm.input;
  mutable cursor : int;  (* before it all is known to be well-formed, and has been told *)
  mutable fresh : bool;  (* nothing but spaces before it on its line *)
  mutable newlines : int;  (* since the last tag or comment *)
  mutable trivia : Trivia.t list;  (* in reverse *)
  each : element -> unit;
}

let span r start stop = Span.make ~file:(Source.name r.source) ~start ~stop
let refuse ?hint code at fmt = Printf.ksprintf (fun s -> raise (Refused (Diag.error ?hint code at "%s" s))) fmt

(* {1 Going over what Xmlm has read} *)

let is_space c = c = ' ' || c = '\t' || c = '\n' || c = '\r'
let rec spaces text i = if i < String.length text && is_space text.[i] then spaces text (i + 1) else i

let rec until text stops i =
  if i < String.length text && not (stops text.[i]) then until text stops (i + 1) else i

let starts text part i =
  let n = String.length part in
  i + n <= String.length text && String.equal (String.sub text i n) part

(* The offset after the next [part]. *)
let rec after text part i =
  match String.index_from_opt text i part.[0] with
  | None -> String.length text
  | Some j -> if starts text part j then j + String.length part else after text part (j + 1)

let blank r =
  if r.newlines > 1 then
    r.trivia <- { kind = Blank; text = ""; start = r.cursor - 1; stop = r.cursor; own_line = true } :: r.trivia;
  r.newlines <- 0

let comment r start stop =
  blank r;
  let kind, text = Comment.read (String.sub r.text (start + 4) (max 0 (stop - start - 7))) in
  r.trivia <- { kind; text; start; stop; own_line = r.fresh } :: r.trivia;
  r.fresh <- false

(* Moves the cursor to the next tag, or to the end. *)
let rec to_tag r =
  let n = String.length r.text in
  if r.cursor < n then
    match r.text.[r.cursor] with
    | '<' when starts r.text "<!--" r.cursor ->
      let stop = after r.text "-->" (r.cursor + 4) in
      comment r r.cursor stop;
      r.cursor <- stop;
      to_tag r
    | '<' when starts r.text "<?" r.cursor -> skip r "?>"
    | '<' when starts r.text "<![CDATA[" r.cursor -> skip r "]]>"
    | '<' -> ()
    | c ->
      if c = '\n' then begin
        r.fresh <- true;
        r.newlines <- r.newlines + 1
      end
      else if not (is_space c) then begin
        r.fresh <- false;
        r.newlines <- 0
      end;
      r.cursor <- r.cursor + 1;
      to_tag r

and skip r mark =
  r.cursor <- after r.text mark (r.cursor + 2);
  r.fresh <- false;
  r.newlines <- 0;
  to_tag r

(* {1 What Xmlm says} *)

let shown s = if String.length s <= 40 then s else String.sub s 0 (Utf8.boundary s 37) ^ "..."

let malformed r place (e : Xmlm.error) =
  let last = Utf8.boundary r.text (min place (max 0 (String.length r.text - 1))) in
  let at = span r last (min (String.length r.text) (last + 1)) in
  (* Of a reference Xmlm has read the end. *)
  let reference () =
    match String.rindex_from_opt r.text last '&' with Some first -> span r first (last + 1) | None -> at
  in
  let refuse_here fmt = refuse Code.xml_malformed at fmt in
  match e with
  | `Unknown_entity_ref name ->
    refuse Code.xml_refused (reference ()) ~hint:"a character is written as it is, or by its number: `&#45;`"
      "`&%s;` is no entity of XML itself, and others are not read" (shown name)
  | `Unexpected_eoi -> refuse_here "the text ends here, before the document does"
  | `Unknown_ns_prefix p -> refuse_here "the prefix `%s` is bound to no namespace" (shown p)
  | `Illegal_char_ref c -> refuse Code.xml_malformed (reference ()) "`&#%s;` is no character of XML" (shown c)
  | `Illegal_char_seq s -> refuse_here "`%s` does not fit here in XML" (shown s)
  | `Expected_root_element -> refuse_here "the first element of the document is expected here"
  | `Expected_char_seqs (wanted, found) ->
    let wanted = List.map (fun s -> Printf.sprintf "`%s`" (shown s)) wanted in
    refuse_here "%s is expected here, and not `%s`" (String.concat " or " wanted) (shown found)
  | `Malformed_char_stream -> refuse_here "this character is none of XML"
  | `Max_buffer_size | `Unknown_encoding _ -> refuse_here "this is not well-formed XML"

let calling r f =
  let consumed, f = f in
  match f r.input with v -> v | exception Xmlm.Error (_, e) -> malformed r (max 0 (!consumed - 1)) e

(* {1 Tags} *)

let name_of_tag text i = until text (fun c -> is_space c || c = '>' || c = '/') i

let local name =
  match String.index_opt name ':' with
  | None -> name
  | Some i -> String.sub name (i + 1) (String.length name - i - 1)

(* The attributes of the tag whose name ends at [i], with the places of their values; and the end of the tag. *)
let rec raw_attributes text acc i =
  let i = spaces text i in
  if i >= String.length text || text.[i] = '>' then (List.rev acc, i + 1)
  else if text.[i] = '/' then (List.rev acc, i + 2)
  else
    let stop = until text (fun c -> is_space c || c = '=') i in
    let quote = spaces text (spaces text stop + 1) in
    let close = until text (fun c -> c = text.[quote]) (quote + 1) in
    raw_attributes text ((String.sub text i (stop - i), i, (quote + 1, close)) :: acc) (close + 1)

let instances = "http://www.w3.org/2001/XMLSchema-instance"

let check_namespaces r at (((uri, tag), attributes) : Xmlm.tag) =
  if not (String.equal uri r.namespace) then
    refuse Code.xml_unexpected at
      ~hint:(Printf.sprintf "the first element says `xmlns=\"%s\"`" r.namespace)
      "the element `<%s>` is not of the namespace of models" (shown tag);
  let foreign ((uri, _), _) = not (List.exists (String.equal uri) [ ""; instances; Xmlm.ns_xmlns ]) in
  match List.find_opt foreign attributes with
  | Some ((_, name), _) -> refuse Code.xml_unexpected at "the attribute `%s` is of another namespace" (shown name)
  | None -> ()

let check_twice r names =
  let known = Hashtbl.create 8 in
  let check (name, at, _) =
    if Hashtbl.mem known name then
      refuse Code.xml_malformed
        (span r at (at + String.length name))
        "the attribute `%s` is given twice" (shown name);
    Hashtbl.add known name ()
  in
  List.iter check names

let own (name, _, _) = not (String.equal name "xmlns" || String.contains name ':')

(* {1 Elements} *)

let rec element r consumed depth (tag : Xmlm.tag) =
  to_tag r;
  blank r;
  r.fresh <- false;
  let start = r.cursor in
  let named = name_of_tag r.text (start + 1) in
  let attributes, stop = raw_attributes r.text [] named in
  let at = span r start stop in
  if depth > max_nesting then
    refuse Code.too_deep at "elements are nested too deeply (the limit is %d)" max_nesting;
  check_namespaces r at tag;
  if List.compare_length_with attributes max_attributes > 0 then
    refuse Code.xml_unexpected at "more than %d attributes belong to no element" max_attributes;
  check_twice r attributes;
  r.cursor <- stop;
  let empty = r.text.[stop - 2] = '/' in
  let leaf, children, stray = content r consumed depth true [] None in
  let value (name, at, (start, stop)) =
    (name, (span r at (at + String.length name), Characters.attribute r.source start stop))
  in
  let close =
    if empty then stop
    else begin
      to_tag r;
      blank r;
      r.cursor
    end
  in
  (match stray with
   | Some at when not leaf -> refuse Code.xml_unexpected at "text does not belong here, between elements"
   | Some _ | None -> ());
  let text = if leaf then Characters.content r.source stop close else Characters.none r.source close in
  if not empty then begin
    r.cursor <- after r.text ">" r.cursor;
    r.fresh <- false
  end;
  {
    tag = local (String.sub r.text (start + 1) (named - start - 1)); at; whole = span r start r.cursor;
    attributes = List.map value (List.filter own attributes); children; text;
  }

(* Up to the end of the element: whether it has none in it, those that are kept, and where text stands that is
   not only spaces. *)
and content r consumed depth leaf children stray =
  match calling r (consumed, Xmlm.input) with
  | `El_end -> (leaf, List.rev children, stray)
  | `El_start tag ->
    let child = element r consumed (depth + 1) tag in
    if depth = 1 then begin
      r.each child;
      content r consumed depth false children stray
    end
    else content r consumed depth false (child :: children) stray
  | `Data s when String.for_all is_space s -> content r consumed depth leaf children stray
  | `Data _ ->
    let i = spaces r.text r.cursor in
    content r consumed depth leaf children (Some (span r i (i + 1)))
  | `Dtd _ -> Bug.fail __POS__ "a document type within an element"

(* {1 Documents} *)

let check_encoding r first =
  let stop = after r.text "?>" first in
  if starts r.text "<?xml" first && is_space r.text.[first + 5] then
    let declaration = String.sub r.text first (stop - first) in
    let word = after declaration "encoding" 0 in
    if word < String.length declaration then begin
      let quote = until declaration (fun c -> c = '"' || c = '\'') word in
      let close = until declaration (fun c -> c = declaration.[quote]) (quote + 1) in
      let encoding = String.sub declaration (quote + 1) (close - quote - 1) in
      match String.lowercase_ascii encoding with
      | "utf-8" | "us-ascii" | "ascii" -> ()
      | _ ->
        refuse Code.xml_refused (span r (first + quote + 1) (first + close)) ~hint:"save the file as UTF-8"
          "the encoding `%s` is not read" (shown encoding)
    end

let document r consumed first =
  (match calling r (consumed, Xmlm.input) with
   | `Dtd None -> ()
   | `Dtd (Some _) ->
     to_tag r;
     refuse Code.xml_refused (span r r.cursor (min (String.length r.text) (r.cursor + 9)))
       "a document type is not read: models have neither entities of their own nor defaults"
   | `El_start _ | `El_end | `Data _ -> Bug.fail __POS__ "a document begins with its type, or none");
  check_encoding r first;
  match calling r (consumed, Xmlm.input) with
  | `El_start tag ->
    let root = element r consumed 1 tag in
    if not (calling r (consumed, Xmlm.eoi)) then begin
      let i = spaces r.text r.cursor in
      refuse Code.xml_malformed (span r i (min (String.length r.text) (i + 1)))
        "nothing but comments follows the first element of a document"
    end;
    to_tag r;
    blank r;
    { root; trivia = List.rev r.trivia }
  | `Dtd _ | `El_end | `Data _ -> Bug.fail __POS__ "a document has a first element"

let read ~namespace ~each source =
  let text = Source.text source in
  let first = Source.after_mark text in
  let consumed = ref first in
  let next () =
    if !consumed >= String.length text then raise End_of_file;
    incr consumed;
    Char.code text.[!consumed - 1]
  in
  let input = Xmlm.make_input ~enc:(Some `UTF_8) (`Fun next) in
  let r = { source; text; namespace; input; cursor = first; fresh = true; newlines = 0; trivia = []; each } in
  match Utf8.check text with
  | Some fault -> Error (Tokens.not_text (Source.name source) fault)
  | None -> ( match document r consumed first with v -> Ok v | exception Refused d -> Error d)
