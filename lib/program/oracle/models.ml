open Scc_base
open Scc_data
open Scc_exact
open Scc_syntax
open Scc_calculus
open Scc_loading
open Scc_json
open Scc_runs

type loaded = { model : Loaded.t; network : Network_at.t }

(* What a model was made of, so that it can be made anew. *)
type given = {
  source : Source.t;
  files : (string * string) list;
  overrides : (string * Rat.t) list;
  narrowed : (string * (Ranges.bound * Ranges.bound)) list;
  tree : Ast.model;
  others : Loaded.reader;  (** of files that are not among these *)
}

type kept = { given : given; mutable loaded : loaded option }
type asked = { handle : string; formula : string; form : string; answer : loaded }
type store = { models : kept Handles.t; read_file : Loaded.reader; lately : asked Last_few.t }

let most_lately = 8
let no_files _ = Error "it is not among the files of the request"

let store (q : Quotas.t) ~read_file =
  let models = Handles.create ~prefix:"m" ~limit:"models" ~most:q.models in
  { models; read_file; lately = Last_few.create ~most:most_lately }

(* {1 Making} *)

let text_name = "<model>"
let formula_name = "<formula>"

let of_tree given tree =
  let read_file name =
    match List.assoc_opt name given.files with Some text -> Ok text | None -> given.others name
  in
  Loaded.of_tree ~read_file ~overrides:given.overrides ~narrowed:given.narrowed given.source tree

let ready model =
  let* () = Ordinary.at_point ~otherwise:"with the member `start`, `model.load` chooses them" model in
  let* () = Ordinary.on_grid model in
  let* initial = Loaded.initial model in
  Ok { model; network = Network_at.make model.semantics ~initial }

let source_of given name =
  if String.equal name text_name then Some given.source
  else
    let text =
      match List.assoc_opt name given.files with
      | Some _ as found -> found
      | None -> Result.to_option (given.others name)
    in
    Option.map (fun text -> Source.make ~name text) text

let refuse given diagnostics =
  Fault.refuse (Model_refused (Fault.diagnostics ~source:(source_of given) diagnostics))

let loaded kept =
  match kept.loaded with
  | Some l -> l
  | None -> (
      match Result.bind (of_tree kept.given kept.given.tree) ready with
      | Ok l ->
        kept.loaded <- Some l;
        l
      | Error diagnostics -> refuse kept.given diagnostics)

let model store p at v = loaded (Handles.find store.models p at v)

let forget store =
  Last_few.retain store.lately (fun _ -> false);
  Handles.iter (fun k -> k.loaded <- None) store.models

let choices p =
  let most = (Read.quotas p).path in
  let choices = Read.short_list Read.natural ~limit:"path" ~most in
  Array.of_list (Option.value (Read.optional p "path" choices) ~default:[])

let path p network = Network_at.follow network (choices p)

(* {1 Methods} *)

let bytes given =
  let file sum (name, text) = sum + String.length name + String.length text in
  List.fold_left file (String.length (Source.text given.source)) given.files

let leaf (l : Model.leaf) =
  `Assoc
    ([ ("name", Json.text l.name); ("shape", Json.text l.template); ("fixed", `Bool l.fixed) ]
     @ if l.absorbs then [ ("absorbs", `Bool true) ] else [])

let check (c : Scc_property.Property.check) =
  `Assoc [ ("name", Json.text c.name); ("formula", Json.text c.text) ]

let describe given handle l =
  let m = l.model in
  let list encode items = `List (List.map encode items) in
  `Assoc
    [
      ("model", `String handle);
      ("digest", `String m.origin.digest);
      ("name", Json.option Json.text m.origin.name);
      ("parameters", Origin_json.parameters m.origin);
      ("settings", Origin_json.settings m.origin);
      ("rigid", `Bool (Option.is_some m.model.rigid));
      ("resolution", Json.option Json.rat (Model.resolution m.model));
      ("leaves", list leaf (Array.to_list m.model.leaves));
      ("checks", list check m.checks);
      ("warnings", `List (Fault.diagnostics ~source:(source_of given) m.warnings));
    ]

let bound p at v : Ranges.bound =
  let b = Read.fields p at v in
  Read.only b [ "value"; "included" ];
  { value = Read.required b "value" Read.rational; included = Read.required b "included" Read.truth }

(* A value, the two ends of a range, or a range as answers tell it. *)
let setting p at (v : Wire.t) =
  let included value : Ranges.bound = { value; included = true } in
  match v with
  | List _ -> (
      match Read.list Read.rational p at v with
      | [ low; high ] -> Either.Right (included low, included high)
      | _ -> Fault.invalid at "the least and the greatest value of a range are expected")
  | Object _ ->
    let r = Read.fields p at v in
    Read.only r [ "low"; "high" ];
    Either.Right (Read.required r "low" bound, Read.required r "high" bound)
  | Null | Bool _ | Number _ | Text _ -> Either.Left (Read.rational p at v)

let settings p =
  let all = Option.value (Read.optional p "parameters" (Read.entries setting)) ~default:[] in
  let side (name, s) = match s with Either.Left v -> Either.Left (name, v) | Right r -> Right (name, r) in
  List.partition_map side all

(* The model of a request, as it is written. *)
let given ?(more = []) store p =
  Read.only p ([ "text"; "files"; "parameters"; "limits" ] @ more);
  let source = Source.make ~name:text_name (Read.required p "text" Read.text) in
  let files = Option.value (Read.optional p "files" (Read.entries Read.text)) ~default:[] in
  let overrides, narrowed = settings p in
  let given = { source; files; overrides; narrowed; tree = []; others = store.read_file } in
  let most = (Read.quotas p).model_bytes in
  if bytes given > most then Fault.refuse (Limit ("model_bytes", most));
  match Scc_notation.Notation.model source with
  | Error diagnostics -> refuse given diagnostics
  | Ok tree -> { given with tree }

let read store ~more p =
  let given = given ~more store p in
  match of_tree given given.tree with
  | Error diagnostics -> refuse given diagnostics
  | Ok model -> (model, source_of given)

let start p at : Wire.t -> Sample.how = function
  | Text "simple" -> Simple
  | Object _ as v ->
    let p = Read.fields p at v in
    Read.only p [ "random" ];
    Random (Read.required p "random" Read.seed)
  | _ -> Fault.invalid at "`simple` or `random` with a seed is expected"

(* With values for what has none yet: a handle stands for one start. *)
let at_start given how =
  match of_tree given given.tree with
  | Error diagnostics -> refuse given diagnostics
  | Ok l -> { given with overrides = List.append given.overrides (Sample.values how l.model.ranges) }

let load store p =
  Handles.check_room store.models;
  let given = given ~more:[ "start" ] store p in
  let given = Option.fold ~none:given ~some:(at_start given) (Read.optional p "start" start) in
  let kept = { given; loaded = None } in
  let l = loaded kept in
  let handle = Handles.add store.models kept in
  Reply.Value (describe given handle l)

let release store p =
  Read.only p [ "model"; "limits" ];
  let handle = Read.required p "model" Read.text in
  ignore (Handles.release store.models handle);
  Last_few.retain store.lately (fun a -> not (String.equal a.handle handle));
  Reply.Value (`Assoc [ ("released", `String handle) ])

(* {1 With a formula} *)

let kept_of store handle = Handles.get store.models handle

let sources store handle ~formula name =
  if String.equal name formula_name then Some (Source.make ~name formula)
  else source_of (kept_of store handle).given name

let with_formula store ~handle ~formula form =
  let name = Question.name form in
  let same a =
    String.equal a.handle handle && String.equal a.form name && String.equal a.formula formula
  in
  match Last_few.find store.lately same with
  | Some a -> Ok a.answer
  | None ->
    let base = loaded (kept_of store handle) in
    let* e = Scc_syntax.Parse.expression (Source.make ~name:formula_name formula) in
    let* model = Loaded.with_checks base.model [ Question.item form e ] in
    let* answer = ready model in
    Last_few.keep store.lately { handle; formula; form = name; answer };
    Ok answer
