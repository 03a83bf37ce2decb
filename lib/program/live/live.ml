open Scc_json
open Scc_oracle
open Scc_view

(* {1 Rows that the page does not have} *)

type have = { solids : int; behaviours : int; processes : int; labels : int; states : int }

let count name = Read.member name Read.natural
let solids = count "solids"
let behaviours = count "behaviours"
let processes = count "processes"
let labels = count "labels"
let states = count "states"

let have =
  let read _ _ p =
    {
      solids = Read.required p solids;
      behaviours = Read.required p behaviours;
      processes = Read.required p processes;
      labels = Read.required p labels;
      states = Read.required p states;
    }
  in
  let members = List.map Read.needs [ solids; behaviours; processes; labels; states ] in
  Read.(member "have" (map read (fields members)))

let states_since states n =
  List.init (Int.max 0 (States.count states - n)) (fun i -> Json.line (States.json states (n + i)))

let more (d : Document.t) have looked =
  let rows all since = Reply.Printed (Rows.since all since) in
  let looked_at n = Json.line (`List [ `Int n; States.json d.states n ]) in
  Reply.Fields
    [
      ("solids", rows d.tables.solids have.solids);
      ("behaviours", rows d.tables.behaviours have.behaviours);
      ("processes", rows d.tables.processes have.processes);
      ("labels", rows d.tables.labels have.labels);
      ("states", Printed (states_since d.states have.states));
      ("looked", Printed (List.map looked_at (List.sort_uniq Int.compare looked)));
    ]

(* {1 Looking at states} *)

(* Tells all of a state, and what is possible there. *)
let look p (d : Document.t) n =
  let world, state = States.home d.states n in
  let most = (Read.quotas p).states in
  Graph.reach d.states world ~most (n, state);
  if not (States.told d.states n) then Fault.refuse (Limit ("states", most));
  let next = Option.value (States.next d.states n) ~default:[] in
  List.filter_map (fun (possible : States.possible) -> possible.target) next

let state_member = count "state"

let state (d : Document.t) p =
  let n = Read.required p state_member in
  if n < States.count d.states then n
  else Fault.invalid (Read.place p state_member) "the document has no such state"

let members = Read.[ needs state_member; needs have; Method.limits ]

let expand d p =
  Read.only p members;
  let have = Read.required p have in
  let n = state d p in
  ignore (look p d n);
  Reply.Fields [ ("more", more d have [ n ]) ]

let told d have ~choices ~looked =
  let choices = Reply.Value (`List (List.rev_map (fun k -> `Int k) choices)) in
  Reply.Fields [ ("choices", choices); ("more", more d have looked) ]

let choices = Read.member "choices" (Read.short_list Read.natural ~limit:"path" (fun q -> q.path))

let walk d p =
  Read.only p (Read.needs choices :: members);
  let have = Read.required p have in
  let wanted = Read.required p choices in
  let rec from n taken looked wanted =
    let possible = look p d n in
    let looked = n :: looked in
    match wanted with
    | [] -> told d have ~choices:taken ~looked
    | k :: rest -> (
        match List.nth_opt possible k with
        | None -> told d have ~choices:taken ~looked
        | Some target -> from target (k :: taken) looked rest)
  in
  from (state d p) [] [] wanted

let most_onwards = 1000

let most = count "most"

let onwards d p =
  Read.only p (Read.needs most :: members);
  let have = Read.required p have in
  let most = Int.min most_onwards (Read.required p most) in
  let rec from n taken looked left =
    match look p d n with
    | target :: _ when left > 0 ->
      let looked = n :: looked in
      if List.mem target looked then told d have ~choices:(0 :: taken) ~looked
      else from target (0 :: taken) looked (left - 1)
    | [] | _ :: _ -> told d have ~choices:taken ~looked:(n :: looked)
  in
  from (state d p) [] [] most

let methods d =
  let on f : Oracle.work = fun _ ~seconds:_ p -> f d p in
  [ ("document.expand", on expand); ("document.walk", on walk); ("document.onwards", on onwards) ]
