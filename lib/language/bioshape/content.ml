open Scc_base
open Scc_syntax

type report = { mutable found : Diag.t list; mutable count : int }

let report () = { found = []; count = 0 }
let faults r = List.sort_uniq Diag.compare r.found

let add r d =
  r.found <- d :: r.found;
  r.count <- r.count + 1;
  if r.count >= Parse.max_errors then raise Document.Stop

let error ?hint r code at fmt = Printf.ksprintf (fun s -> add r (Diag.error ?hint code at "%s" s)) fmt

type t = {
  reports : report;
  element : Document.element;
  mutable attributes : (string * (Span.t * Embedded.t)) list;
  mutable asked : string list;  (* attributes that it may have *)
  mutable children : Document.element list;
  mutable text : bool;  (* whether its text is asked for *)
}

let of_element reports (element : Document.element) =
  { reports; element; attributes = element.attributes; asked = []; children = element.children; text = false }

let reports t = t.reports
let element t = t.element

let finish t =
  let attribute (key, (at, _)) =
    let hint = Diag.suggest key t.asked in
    error t.reports ?hint Code.xml_unexpected at "`<%s>` has no attribute `%s`" t.element.tag key
  in
  List.iter attribute t.attributes;
  (match t.children with
   | [] -> ()
   | child :: _ -> error t.reports Code.xml_unexpected child.at "`<%s>` does not belong here in `<%s>`" child.tag
                     t.element.tag);
  if (not t.text) && String.length t.element.text.text > 0 then
    error t.reports Code.xml_unexpected (Embedded.span t.element.text) "`<%s>` holds no text" t.element.tag

(* {1 Attributes} *)

type 'a text = { read : Embedded.t -> ('a, Diag.t list) result; instead : Span.t -> 'a }

let loc it at = { Ast.it; at }
let some at = loc "_" at
let segment_at at : Ast.segment = { name = some at; indices = [] }
let path_at at : Ast.path = loc [ segment_at at ] at
let feature_at at : Ast.feature = loc (Ast.Named (path_at at)) at
let reference_at at : Ast.reference = { qualifier = None; target = some at; indices = []; arguments = [] }
let name = { read = Embedded.name; instead = some }
let word = { read = Embedded.word; instead = some }
let rounded = { read = Embedded.rounded; instead = some }
let expression = { read = Embedded.expression; instead = loc (Ast.Number Q.zero) }
let path = { read = Embedded.path; instead = path_at }
let segment = { read = Embedded.segment; instead = segment_at }
let feature = { read = Embedded.feature; instead = feature_at }
let member ~only = { read = Embedded.member ~only; instead = (fun at -> { Ast.feature = feature_at at; only }) }
let template = { read = Embedded.template; instead = reference_at }
let behaviour = { read = Embedded.behaviour; instead = reference_at }

let plain_head =
  let head declared = { Ast.declared; places = []; formals = [] } in
  { read = (fun e -> Result.map head (Embedded.name e)); instead = (fun at -> head (some at)) }

let head = { read = Embedded.head; instead = (fun at -> { Ast.declared = some at; places = []; formals = [] }) }

let refuse code e fmt = Printf.ksprintf (fun s -> Error [ Diag.error code (Embedded.span e) "%s" s ]) fmt

(* The words of a text, each a piece of its own. *)
let words (e : Embedded.t) =
  let is_space c = c = ' ' || c = '\n' || c = '\t' in
  let n = String.length e.text in
  let rec go acc i =
    if i >= n then List.rev acc
    else if is_space e.text.[i] then go acc (i + 1)
    else
      let rec stop j = if j < n && not (is_space e.text.[j]) then stop (j + 1) else j in
      let j = stop i in
      let place k = e.place (i + k) in
      go ({ e with text = String.sub e.text i (j - i); place } :: acc) j
  in
  go [] 0

let names =
  let read e =
    match words e with
    | [] -> refuse Code.xml_missing e "names are missing here"
    | words -> Result.all Embedded.name words
  in
  { read; instead = (fun _ -> []) }

let line =
  let read (e : Embedded.t) =
    if String.contains e.text '\n' || String.contains e.text '\r' then
      refuse Code.syntax e "a text on one line is expected here"
    else Ok (loc e.text (Embedded.span e))
  in
  { read; instead = (fun at -> loc "" at) }

let choice those =
  let read (e : Embedded.t) =
    match List.assoc_opt (String.trim e.text) those with
    | Some v -> Ok v
    | None -> refuse Code.syntax e "one of these is expected here: %s" (String.concat ", " (List.map fst those))
  in
  { read; instead = (fun _ -> snd (List.hd those)) }

let flag = choice [ ("false", false); ("true", true); ("0", false); ("1", true) ]

let value t kind (e : Embedded.t) =
  match kind.read e with
  | Ok v -> v
  | Error faults ->
    List.iter (add t.reports) faults;
    kind.instead (Embedded.span e)

let has t key = List.mem_assoc key t.attributes

let optional t key kind =
  t.asked <- key :: t.asked;
  match List.assoc_opt key t.attributes with
  | None -> None
  | Some (_, e) ->
    t.attributes <- List.remove_assoc key t.attributes;
    Some (value t kind e)

let required t key kind =
  match optional t key kind with
  | Some v -> v
  | None ->
    let hint = Diag.suggest key (List.map fst t.attributes) in
    error t.reports ?hint Code.xml_missing t.element.at "`<%s>` has to have the attribute `%s`" t.element.tag key;
    kind.instead t.element.at

let content t kind =
  t.text <- true;
  value t kind t.element.text

(* {1 Elements} *)

let next t = match t.children with [] -> None | e :: _ -> Some e.tag

let take t =
  match t.children with
  | [] -> None
  | e :: rest ->
    t.children <- rest;
    Some e

let within t e f =
  let inner = of_element t.reports e in
  let v = f inner in
  finish inner;
  v

let many t tags f =
  let rec go acc =
    match t.children with
    | e :: rest when List.exists (String.equal e.tag) tags ->
      t.children <- rest;
      go (within t e f :: acc)
    | _ -> List.rev acc
  in
  go []

let one t tag f =
  match t.children with
  | e :: rest when String.equal e.tag tag ->
    t.children <- rest;
    Some (within t e f)
  | _ -> None

let missing t fmt =
  let at =
    match t.children with
    | e :: _ -> e.at
    | [] -> t.element.at
  in
  Printf.ksprintf (fun s -> add t.reports (Diag.error Code.xml_missing at "%s" s)) fmt
