open Scc_base
open Scc_exact
open Scc_json
open Json_format

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

(* {1 The format} *)

let versions = [ 1; 2 ]

let version (origin : Scc_loading.Origin.t) =
  if List.exists (fun setting -> setting = Scc_calculus.Parameters.at_any_time) origin.settings then 2 else 1

let version_format = one_of versions ~what:"one of 1 and 2, the versions of the format that this scc reads"
let numbered ~index ~label at = { index; label; at }

let choice_format =
  let neither (json : Json.t) =
    match (Json.member "choice" json, Json.member "label" json) with
    | None, None -> Some "needs a number `choice` or a text `label`"
    | _ -> None
  in
  let alternative name = `Assoc [ ("required", `List [ `String name ]) ] in
  obj
    (let+ index =
       optional "choice" natural (fun c -> c.index)
         ~about:
           "The number of the transition among those possible, from 0; of a time that is less than the \
            greatest, that of the time, or the number after all others where time may pass for ever."
     and+ label = optional "label" text (fun c -> c.label) ~about:"The text of its label." in
     numbered ~index ~label)
  |> constrained [ ("anyOf", `List [ alternative "choice"; alternative "label" ]) ] neither

(* The places of choices are those of the text; the parser keeps none. *)
let format =
  let version =
    required "version" version_format fst
      ~about:
        "2 where bonds may be released at any time (split_step any), and a label time(d) may be less than the \
         greatest time."
  in
  let choices = required "choices" (list choice_format) (fun (_, s) -> s.choices) in
  obj
    (let+ () = fixed "format" (`String "scc-schedule")
     and+ _ = version
     and+ model =
       optional "model" text (fun (_, s) -> s.model)
         ~about:"The path of the model, as it was given when the schedule was made."
     and+ check = optional "check" text (fun (_, s) -> s.check)
         ~about:"The property that the run is a witness for."
     and+ digest = optional "digest" Shared.digest (fun (_, s) -> s.digest)
     and+ parameters = optional "parameters" Origin_json.parameters_format (fun (_, s) -> Some s.parameters)
     and+ choices = choices
     and+ offset =
       optional "offset" duration (fun (_, s) -> s.offset)
         ~about:"Time that passes after the last choice without an event: the instant that a witness is about."
     in
     fun place ->
       let parameters = Option.value parameters ~default:[] in
       let choices = List.mapi (fun i choice -> choice (place i)) choices in
       { model; check; digest; parameters; choices; offset; offset_at = Span.none })

(* {1 Writing} *)

let made ?model ?check (origin : Scc_loading.Origin.t) choices ~offset =
  let choice (index, label) = numbered ~index:(Some index) ~label:(Some label) Span.none in
  let { Scc_loading.Origin.digest; parameters; _ } = origin in
  let choices = List.map choice choices in
  (version origin, { model; check; digest = Some digest; parameters; choices; offset; offset_at = Span.none })

let to_string schedule =
  let b = Buffer.create 1024 in
  let separated separator add items =
    List.iteri
      (fun i x ->
         if i > 0 then Buffer.add_string b separator;
         add x)
      items
  in
  let member (name, (json : Json.t)) =
    Printf.bprintf b "\"%s\": " name;
    match json with
    | `List items ->
      Buffer.add_char b '[';
      separated "," (fun x -> Buffer.add_string b ("\n    " ^ Json.line x)) items;
      Buffer.add_string b " ]"
    | _ -> Buffer.add_string b (Json.line json)
  in
  (match write format schedule with
   | `Assoc members ->
     Buffer.add_string b "{ ";
     separated ",\n  " member members;
     Buffer.add_string b " }\n"
   | _ -> Bug.fail __POS__ "a schedule that is no object");
  Buffer.contents b

(* {1 Reading} *)

let malformed span fmt = Diag.error Code.bad_schedule span fmt

let is_format name json =
  match Option.bind (Json.member "format" json) Json.string with
  | Some f -> String.equal f name
  | None -> false

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

let of_schedule source json =
  let span start = Span.make ~file:(Source.name source) ~start ~stop:(start + 1) in
  let places = choice_places (Source.text source) in
  let place i = span (if i < Array.length places then places.(i) else 0) in
  let rec at : path -> Span.t = function
    | Whole -> span 0
    | Item (Member (Whole, "choices"), i) -> place i
    | Member (p, _) | Item (p, _) -> at p
  in
  match read format json with
  | Ok schedule -> Ok { (schedule place) with offset_at = span 0 }
  | Error fault -> Error (malformed (at fault.at) "%s" (fault_to_string fault))

(* What a schedule takes from the lines of a trace. *)
let header_format =
  obj
    (let+ version = required "version" version_format (fun (v, _, _) -> v)
     and+ digest = optional "digest" Shared.digest (fun (_, d, _) -> d)
     and+ parameters = optional "parameters" Origin_json.parameters_format (fun (_, _, p) -> p) in
     (version, digest, parameters))

let line_bounds s start =
  let stop = Option.value (String.index_from_opt s start '\n') ~default:(String.length s) in
  (start, stop)

(* A transition has its label as an object. *)
let transition_format =
  let label = obj (optional "text" text Fun.id) in
  obj
    (let+ index = optional "choice" natural fst
     and+ label = optional "label" label (fun (_, label) -> Option.map Option.some label) in
     (index, Option.join label))
  |> into (function None, None -> Error "needs a number `choice` or a `label` with a `text`" | choice -> Ok choice)

let instant_format = obj (required "offset" duration Fun.id)

let of_trace source header =
  let s = Source.text source and file = Source.name source in
  let span (start, _) = Span.make ~file ~start ~stop:(start + 1) in
  let read_at bounds format json =
    Result.map_error (fun fault -> malformed (span bounds) "%s" (fault_to_string fault)) (read format json)
  in
  let first = line_bounds s 0 in
  let* _, digest, parameters = read_at first header_format header in
  let parameters = Option.value parameters ~default:[] in
  let result choices offset offset_at =
    Ok { model = None; check = None; digest; parameters; choices = List.rev choices; offset; offset_at }
  in
  let rec lines start choices =
    if start >= String.length s then result choices None (span first)
    else
      let ((_, stop) as bounds) = line_bounds s start in
      let* json = Json.parse_line source ~start ~stop in
      match Option.bind (Json.member "type" json) Json.string with
      | Some "transition" ->
        let* index, label = read_at bounds transition_format json in
        lines (stop + 1) (numbered ~index ~label (span bounds) :: choices)
      | Some "instant" ->
        let* offset = read_at bounds instant_format json in
        result choices (Some offset) (span bounds)
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
