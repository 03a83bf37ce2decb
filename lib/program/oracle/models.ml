open Scc_base
open Scc_data
open Scc_exact
open Scc_syntax
open Scc_calculus
open Scc_loading
open Scc_json
open Scc_runs
open Json_format

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

let handle = Read.member "model" { Read.text with schema = Json_format.schema Answers.model }
let model store p = loaded (Handles.get store.models (Read.required p handle))

let forget store =
  Last_few.retain store.lately (fun _ -> false);
  Handles.iter (fun k -> k.loaded <- None) store.models

let along =
  let choices = Read.short_list Read.natural ~limit:"path" (fun q -> q.path) in
  Read.member "path" { choices with schema = Json_format.schema Answers.path }

let choices p = Array.of_list (Option.value (Read.optional p along) ~default:[])

let path p network = Network_at.follow network (choices p)

(* {1 Methods} *)

let bytes given =
  let file sum (name, text) = sum + String.length name + String.length text in
  List.fold_left file (String.length (Source.text given.source)) given.files

let loaded_format =
  let model f (_, _, l) = f l.model and own f (_, _, l) = f l.model.model in
  let leaf =
    fields
      [
        field "name" text (fun (l : Model.leaf) -> l.name);
        field "shape" text (fun (l : Model.leaf) -> l.template);
        field "fixed" bool (fun (l : Model.leaf) -> l.fixed);
        maybe "absorbs" (constant (`Bool true)) (fun (l : Model.leaf) -> if l.absorbs then Some () else None);
      ]
  in
  let check =
    fields
      [
        field "name" text (fun (c : Scc_property.Property.check) -> c.name);
        field "formula" text (fun (c : Scc_property.Property.check) -> c.text);
      ]
  in
  fields
    [
      field "model" Answers.model (fun (_, handle, _) -> handle);
      field "digest" Shared.digest (model (fun m -> m.origin.digest));
      field "name" (nullable text) (model (fun m -> m.origin.name));
      field "parameters" Origin_json.parameters_format (model (fun m -> m.origin.parameters));
      field "settings" Origin_json.settings_format (model (fun m -> m.origin.settings));
      field "rigid" bool (own (fun m -> Option.is_some m.rigid));
      field "resolution" (nullable Shared.rational) (own Model.resolution);
      field "leaves" (list leaf) (own (fun m -> Array.to_list m.leaves));
      field "checks" (list check) (model (fun m -> m.checks));
      field "warnings" Diag_json.formats (fun (given, _, l) -> (source_of given, l.model.warnings));
    ]

let bound =
  let number = Read.member "value" Read.rational and included = Read.member "included" Read.truth in
  let bound _ _ p : Ranges.bound = { value = Read.required p number; included = Read.required p included } in
  let r = Read.(map bound (fields [ needs number; needs included ])) in
  { r with schema = Read.defined "bound" r.schema }

(* A value, the two ends of a range, or a range as answers tell it. *)
let setting =
  let included value : Ranges.bound = { value; included = true } in
  let low = Read.member "low" bound and high = Read.member "high" bound in
  let range = Read.fields Read.[ needs low; needs high ] in
  let ends = Json_schema.Items { each = Read.rational.schema; least = 2; most = Some 2; distinct = false } in
  let text = "A value of a parameter, or a range that it is narrowed to: both ends included, or told of each." in
  let schema = Json_schema.About (text, Any_of [ Read.rational.schema; ends; range.schema ]) in
  Read.reader (Read.defined "setting" schema) (fun p at -> function
      | List _ as v -> (
          match (Read.list Read.rational).value p at v with
          | [ low; high ] -> Either.Right (included low, included high)
          | _ -> Fault.invalid at "the least and the greatest value of a range are expected")
      | Object _ as v ->
        let r = range.value p at v in
        Either.Right (Read.required r low, Read.required r high)
      | (Null | Bool _ | Number _ | Text _) as v -> Either.Left (Read.rational.value p at v))

let parameters = Read.member "parameters" (Read.entries setting)

let settings p =
  let all = Option.value (Read.optional p parameters) ~default:[] in
  let side (name, s) = match s with Either.Left v -> Either.Left (name, v) | Right r -> Right (name, r) in
  List.partition_map side all

let text_member = Read.member "text" Read.text
let files_member = Read.member "files" (Read.entries Read.text)
let members = Read.[ needs text_member; may files_member; may parameters ]

(* The model of a request, as it is written. *)
let given ~params store p =
  Read.only p params;
  let source = Source.make ~name:text_name (Read.required p text_member) in
  let files = Option.value (Read.optional p files_member) ~default:[] in
  let overrides, narrowed = settings p in
  let given = { source; files; overrides; narrowed; tree = []; others = store.read_file } in
  let most = (Read.quotas p).model_bytes in
  if bytes given > most then Fault.refuse (Limit ("model_bytes", most));
  match Scc_notation.Notation.model source with
  | Error diagnostics -> refuse given diagnostics
  | Ok tree -> { given with tree }

let read store ~params p =
  let given = given ~params store p in
  match of_tree given given.tree with
  | Error diagnostics -> refuse given diagnostics
  | Ok model -> (model, source_of given)

let random_seed = Read.member "random" Read.seed

(* A word, or a seed for random choices. *)
let word_or_seed word ~simple ~random =
  let seeded = Read.fields [ Read.needs random_seed ] in
  let text = "By the generator SplitMix64 from this seed, an integer of 64 bits." in
  let schema = Read.defined "random" (About (text, seeded.schema)) in
  Read.reader (Any_of [ Constant [ `String word ]; schema ]) (fun p at -> function
      | Wire.Text w when String.equal w word -> simple
      | Object _ as v -> random (Read.required (seeded.value p at v) random_seed)
      | _ -> Fault.invalid at "`%s` or `random` with a seed is expected" word)

(* With values for what has none yet: a handle stands for one start. *)
let at_start given how =
  match of_tree given given.tree with
  | Error diagnostics -> refuse given diagnostics
  | Ok l -> { given with overrides = List.append given.overrides (Sample.values how l.model.ranges) }

let load =
  let start =
    Read.member "start" (word_or_seed "simple" ~simple:Sample.Simple ~random:(fun seed -> Sample.Random seed))
      ~about:"What chooses values for those parameters with ranges to which none is given."
  in
  let params = members @ [ Read.may start; Method.limits ] in
  let work store p =
    Handles.check_room store.models;
    let given = given ~params store p in
    let given = Option.fold ~none:given ~some:(at_start given) (Read.optional p start) in
    let kept = { given; loaded = None } in
    let l = loaded kept in
    let handle = Handles.add store.models kept in
    Reply.of_format loaded_format (given, handle, l)
  in
  { Method.name = "model.load"; params; result = schema loaded_format; work }

let release =
  let work store p =
    let handle = Read.required p handle in
    ignore (Handles.release store.models handle);
    Last_few.retain store.lately (fun a -> not (String.equal a.handle handle));
    handle
  in
  Method.make "model.release" [ Read.needs handle; Method.limits ] Answers.(released model) work

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
