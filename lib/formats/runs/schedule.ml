open Scc_base
open Scc_exact
open Scc_json

type choice = { index : int option; label : string option; at : Span.t }

type t = {
  model : string option;
  check : string option;
  digest : string option;
  parameters : (string * Rat.t) list;
  choices : choice list;
  offset : Rat.t option;
  offset_at : Span.t;
}

let versions = [ 1; 2 ]

let version (origin : Scc_loading.Origin.t) =
  if List.exists (fun setting -> setting = Scc_calculus.Parameters.at_any_time) origin.settings then 2 else 1

let ( let* ) = Result.bind

let to_string ?model ?check (origin : Scc_loading.Origin.t) choices ~offset =
  let b = Buffer.create 1024 in
  let add fmt = Printf.bprintf b fmt in
  add "{ \"format\": \"scc-schedule\",\n  \"version\": %d,\n" (version origin);
  let optional name = Option.iter (fun s -> add "  \"%s\": %s,\n" name (Json.line (Json.text s))) in
  optional "model" model;
  optional "check" check;
  add "  \"digest\": %s,\n" (Json.line (`String origin.digest));
  add "  \"parameters\": %s,\n" (Json.line (Origin_json.parameters origin));
  add "  \"choices\": [";
  List.iteri
    (fun i (index, label) ->
       let choice = `Assoc [ ("choice", `Int index); ("label", Json.text label) ] in
       add "%s\n    %s" (if i = 0 then "" else ",") (Json.line choice))
    choices;
  add " ]";
  Option.iter (fun d -> add ",\n  \"offset\": %s" (Json.line (Json.rat d))) offset;
  add " }\n";
  Buffer.contents b

let malformed span fmt = Diag.error Code.bad_schedule span fmt

let is_format name json =
  match Option.bind (Json.member "format" json) Json.string with
  | Some f -> String.equal f name
  | None -> false

let check_version span json =
  match Option.bind (Json.member "version" json) Json.int with
  | Some v when List.mem v versions -> Ok ()
  | Some v -> Error (malformed span "format version %d is none of 1 and 2, which this scc reads" v)
  | None -> Error (malformed span "there is no `version`")

let parameters span json =
  match Json.member "parameters" json with
  | None -> Ok []
  | Some (`Assoc members) ->
    let add acc (name, value) =
      let* acc = acc in
      match Json.rational value with
      | Some q -> Ok ((name, q) :: acc)
      | None -> Error (malformed span "the value of the parameter `%s` is no rational" name)
    in
    Result.map List.rev (List.fold_left add (Ok []) members)
  | Some _ -> Error (malformed span "`parameters` is not an object")

let digest json = Option.bind (Json.member "digest" json) Json.string

let choice at ~index ~label =
  match (index, label) with
  | None, None -> Error (malformed at "a choice needs a number `choice` or a text `label`")
  | Some (`Int i), _ when i < 0 -> Error (malformed at "`choice` is negative")
  | (None | Some (`Int _)), (None | Some (`String _)) ->
    Ok { index = Option.bind index Json.int; label = Option.bind label Json.string; at }
  | _ -> Error (malformed at "`choice` is a number and `label` a text")

let duration at json =
  match Json.rational json with
  | Some q when Rat.sign q >= 0 -> Ok q
  | _ -> Error (malformed at "`offset` is not a duration: a text \"p/q\" that is at least 0")

(* Where each object inside the array "choices" starts: the parser keeps no places. *)
let choice_places s =
  let places = ref [] and depth = ref 0 and inside = ref false in
  let rec string_end i = match s.[i] with '\\' -> string_end (i + 2) | '"' -> i | _ -> string_end (i + 1) in
  let n = String.length s in
  let rec scan i =
    if i < n then
      match s.[i] with
      | '"' ->
        let stop = string_end (i + 1) in
        if !depth = 1 then inside := String.equal (String.sub s i (stop + 1 - i)) "\"choices\"";
        scan (stop + 1)
      | ('{' | '[') as c ->
        if c = '{' && !depth = 2 && !inside then places := i :: !places;
        incr depth;
        scan (i + 1)
      | '}' | ']' ->
        decr depth;
        scan (i + 1)
      | _ -> scan (i + 1)
  in
  scan 0;
  Array.of_list (List.rev !places)

let collect items f =
  let add acc x =
    let* acc = acc in
    let* y = f x in
    Ok (y :: acc)
  in
  Result.map List.rev (List.fold_left add (Ok []) items)

let optional_text span name json =
  match Json.member name json with
  | None -> Ok None
  | Some (`String s) -> Ok (Some s)
  | Some _ -> Error (malformed span "`%s` is not a text" name)

let of_schedule source json =
  let file = Source.name source in
  let whole = Span.make ~file ~start:0 ~stop:1 in
  let* () = check_version whole json in
  let* parameters = parameters whole json in
  let* model = optional_text whole "model" json in
  let* check = optional_text whole "check" json in
  let* items =
    match Json.member "choices" json with
    | Some (`List items) -> Ok items
    | _ -> Error (malformed whole "there is no array `choices`")
  in
  let places = choice_places (Source.text source) in
  let one (i, json) =
    let start = if i < Array.length places then places.(i) else 0 in
    choice
      (Span.make ~file ~start ~stop:(start + 1))
      ~index:(Json.member "choice" json) ~label:(Json.member "label" json)
  in
  let* choices = collect (List.mapi (fun i json -> (i, json)) items) one in
  let* offset =
    match Json.member "offset" json with
    | None -> Ok None
    | Some json -> Result.map Option.some (duration whole json)
  in
  Ok { model; check; digest = digest json; parameters; choices; offset; offset_at = whole }

let line_bounds s start =
  let stop = Option.value (String.index_from_opt s start '\n') ~default:(String.length s) in
  (start, stop)

let of_trace source header =
  let s = Source.text source and file = Source.name source in
  let span (start, _) = Span.make ~file ~start ~stop:(start + 1) in
  let first = line_bounds s 0 in
  let* () = check_version (span first) header in
  let* parameters = parameters (span first) header in
  let result choices offset offset_at =
    Ok
      {
        model = None; check = None; digest = digest header; parameters; choices = List.rev choices;
        offset; offset_at;
      }
  in
  let rec lines start choices =
    if start >= String.length s then result choices None (span first)
    else
      let ((_, stop) as bounds) = line_bounds s start in
      let* json = Json.parse_line source ~start ~stop in
      match Option.bind (Json.member "type" json) Json.string with
      | Some "transition" ->
        let label = Option.bind (Json.member "label" json) (Json.member "text") in
        let* c = choice (span bounds) ~index:(Json.member "choice" json) ~label in
        lines (stop + 1) (c :: choices)
      | Some "instant" ->
        let offset = Option.value (Json.member "offset" json) ~default:`Null in
        let* d = duration (span bounds) offset in
        result choices (Some d) (span bounds)
      | Some ("state" | "end") -> lines (stop + 1) choices
      | _ -> Error (malformed (span bounds) "this is no line of a trace")
  in
  lines (snd first + 1) []

let read source =
  let s = Source.text source in
  let start, stop = line_bounds s (Source.after_mark s) in
  let header = Result.to_option (Json.parse_line source ~start ~stop) in
  match header with
  | Some json when is_format "scc-trace" json -> of_trace source json
  | _ ->
    let* json = Json.parse source in
    if is_format "scc-schedule" json then of_schedule source json
    else
      let whole = Span.make ~file:(Source.name source) ~start:0 ~stop:1 in
      Error
        (malformed whole "this is neither a schedule (\"format\": \"scc-schedule\") nor a trace of scc")
