open Scc_base
open Scc_exact
open Scc_semantics
open Scc_json
open Scc_runs

let label_text = Transition.label_to_string

let one_of p name choices ~default =
  let at = Read.within p name in
  match Read.optional p name Read.text with
  | None -> default
  | Some s -> (
      match List.assoc_opt s choices with
      | Some x -> x
      | None -> Fault.invalid at "one of these is expected: %s" (String.concat ", " (List.map fst choices)))

let path_json path = `List (List.map (fun c -> `Int c) (Array.to_list path))
let rules list = `List (List.map (fun r -> `String (Rule.id r)) list)

(* {1 successors} *)

type states = Here | Every | Neither

let totals (t : Scc_engine.Totals.t) =
  `Assoc
    [ ("momentum", Json.vec t.momentum); ("angular", Json.vec t.angular); ("energy", Json.rat t.energy) ]

let transition m states choice (t : Transition.t) =
  let state = match states with Every -> [ ("state", State_json.state m t.target) ] | Here | Neither -> [] in
  let added = Scc_engine.Totals.added m t in
  let rounded = Option.map (fun r -> ("rounded", totals (Lazy.force r))) added in
  `Assoc
    ([ ("choice", `Int choice); ("label", State_json.label m t.label); ("rules", rules t.rules) ]
     @ Option.to_list rounded @ state)

let successors store p =
  Read.only p [ "model"; "path"; "states"; "limits" ];
  let { Models.network; _ } = Read.required p "model" (Models.model store) in
  let states = one_of p "states" [ ("here", Here); ("all", Every); ("none", Neither) ] ~default:Here in
  let place = Models.path p network and m = Network_at.model network in
  let next = Network_at.next network place in
  let ending =
    match next with
    | [] -> `String (if Network.quiescent (Network_at.semantics network) place.state then "quiescent" else "stuck")
    | _ :: _ -> `Null
  in
  let here = match states with Here | Every -> State_json.state m place.state | Neither -> `Null in
  Reply.Value
    (`Assoc
       [
         ("path", path_json place.path);
         ("time", Json.rat place.time);
         ("state", here);
         ("transitions", `List (List.mapi (transition m states) next));
         ("ending", ending);
       ])

(* {1 step} *)

let shown s = if String.length s <= 200 then s else "a long label"

let index_of m next label =
  let rec from i = function
    | [] -> None
    | (t : Transition.t) :: rest ->
      if String.equal label (label_text m t.label) then Some i else from (i + 1) rest
  in
  from 0 next

let chosen m next (place : Network_at.place) at : Wire.t -> int option -> int = fun v index ->
  match (v, index) with
  | _, Some i -> i
  | Text label, None -> (
      match index_of m next label with
      | Some i -> i
      | None ->
        let message = Printf.sprintf "`%s` is not possible here" (shown label) in
        Fault.refuse (Not_possible { at = Array.length place.path; possible = Network_at.labels m next; message }))
  | _, None -> Fault.invalid at "an index or the text of a label is expected"

let step store p =
  Read.only p [ "model"; "path"; "choice"; "limits" ];
  let { Models.network; _ } = Read.required p "model" (Models.model store) in
  let m = Network_at.model network and place = Models.path p network in
  let next = Network_at.next network place in
  let choice p at : Wire.t -> int = function
    | Number _ as v -> Read.natural p at v
    | v -> chosen m next place at v None
  in
  let choice = Read.required p "choice" choice in
  let after = Network_at.follow network (Array.append place.path [| choice |]) in
  let taken = List.nth next choice in
  Reply.Value
    (`Assoc
       [
         ("choice", `Int choice);
         ("label", State_json.label m taken.label);
         ("rules", rules taken.rules);
         ("path", path_json after.path);
         ("time", Json.rat after.time);
         ("state", State_json.state m after.state);
       ])

(* {1 replay} *)

let choice p at (v : Wire.t) : Schedule.choice =
  match v with
  | Number _ -> { index = Some (Read.natural p at v); label = None; at = Span.none }
  | Text label -> { index = None; label = Some label; at = Span.none }
  | Object _ ->
    let p = Read.fields p at v in
    Read.only p [ "choice"; "label" ];
    let index = Read.optional p "choice" Read.natural and label = Read.optional p "label" Read.text in
    if Option.is_none index && Option.is_none label then
      Fault.invalid at "`choice` or `label` is needed"
    else { index; label; at = Span.none }
  | Null | Bool _ | List _ -> Fault.invalid at "an index, a label or an object is expected"

let choose p at : Wire.t -> Replay.policy = function
  | Text "first" -> First
  | Object _ as v ->
    let p = Read.fields p at v in
    Read.only p [ "random" ];
    Random (Read.required p "random" Read.seed)
  | _ -> Fault.invalid at "`first` or `random` with a seed is expected"

let policy p : Replay.policy =
  let most = (Read.quotas p).steps in
  let choices = Read.optional p "choices" (Read.short_list choice ~limit:"steps" ~most) in
  let offset = Read.optional p "offset" Read.not_negative in
  match (choices, Read.optional p "choose" choose) with
  | Some choices, None ->
    Scheduled
      {
        model = None;
        check = None;
        digest = None;
        parameters = [];
        choices;
        offset;
        offset_at = Span.none;
      }
  | None, Some policy ->
    if Option.is_some offset then Fault.invalid (Member "offset") "it goes with `choices` only";
    policy
  | None, None -> Fault.invalid (Member "choices") "either `choices` or `choose` is needed"
  | Some _, Some _ -> Fault.invalid (Member "choose") "it does not go with `choices`"

let limits p (policy : Replay.policy) : Replay.limits =
  let most = (Read.quotas p).steps in
  let given = Read.optional p "steps" Read.natural in
  Option.iter (fun n -> if n > most then Fault.refuse (Limit ("steps", most))) given;
  let time = Read.optional p "time" Read.not_negative in
  let steps =
    match (given, policy) with
    | Some n, _ -> Some n
    | None, Scheduled _ -> None
    | None, (First | Random _) -> Some Replay.default_steps
  in
  { steps; time; instant = Replay.default_instant }

(* The lines so far, the last one first; choices, likewise; and how it ended. *)
type told = {
  mutable lines : string list;
  mutable bytes : int;
  mutable taken : int list;
  mutable finish : (int * Rat.t * Replay.ending) option;
}

let tell (q : Quotas.t) told json =
  let line = Json.line json in
  told.bytes <- told.bytes + String.length line + 1;
  if told.bytes > q.reply_bytes then Fault.refuse (Limit ("reply_bytes", q.reply_bytes));
  told.lines <- line :: told.lines

let on_event q m states told (event : Replay.event) =
  (match event with
   | Start _ | Instant _ -> ()
   | Step s -> told.taken <- s.index :: told.taken
   | End e -> told.finish <- Some (e.steps, e.time, e.ending));
  List.iter (tell q told) (Trace.event m states event)

let misfit network told message =
  let place = Network_at.follow network (Array.of_list (List.rev told.taken)) in
  let possible = Network_at.labels (Network_at.model network) (Network_at.next network place) in
  Fault.refuse (Not_possible { at = List.length told.taken; possible; message })

let replay store p =
  Read.only p [ "model"; "choices"; "offset"; "choose"; "steps"; "time"; "states"; "limits" ];
  let { Models.network; model = l } = Read.required p "model" (Models.model store) in
  let policy = policy p in
  let limits = limits p policy and q = Read.quotas p in
  let states = one_of p "states" [ ("all", Trace.All); ("ends", Trace.Ends) ] ~default:Trace.All in
  let told = { lines = []; bytes = 0; taken = []; finish = None } in
  tell q told (Trace.header l.origin);
  let interrupted () = false in
  match Replay.run l.semantics l.declared policy limits ~interrupted (on_event q l.model states told) with
  | Error (Refused d) -> misfit network told d.message
  | Error (Fault f) ->
    let diagnostics = Fault.diagnostics ~source:(fun _ -> None) [ Transition.diagnostic l.model f.fault ] in
    Fault.refuse (No_transitions { at = List.length told.taken; diagnostics })
  | Error (Interrupted _) -> Bug.fail __POS__ "nobody interrupts"
  | Ok _ -> (
      match told.finish with
      | None -> Bug.fail __POS__ "a run without its end"
      | Some (steps, time, ending) ->
        Reply.Fields
          [
            ("lines", Printed (List.rev told.lines));
            ("steps", Value (`Int steps));
            ("time", Value (Json.rat time));
            ("ending", Value (`String (Trace.ending ending)));
          ])
