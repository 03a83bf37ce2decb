open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_json

let header origin =
  `Assoc
    ([
      ("type", `String "header");
      ("format", `String "scc-trace");
      ("version", `Int (Schedule.version origin));
      ("semantics", `String Scc_calculus.Parameters.version);
    ]
      @ Origin_json.members origin)

let ending : Replay.ending -> string = function
  | Open -> "open"
  | Quiescent -> "quiescent"
  | Stuck _ -> "stuck"
  | Zeno -> "zeno"

let why m : Replay.ending -> (string * Json.t) list = function
  | Stuck given_up ->
    [ ("diagnostic", Diag_json.diagnostic ~source:(fun _ -> None) (Replay.diagnostic m given_up)) ]
  | Open | Quiescent | Zeno -> []

type states = All | Ends

let state m ~time s =
  `Assoc [ ("type", `String "state"); ("time", Json.rat time); ("state", State_json.state m s) ]

let totals (t : Scc_engine.Totals.t) =
  `Assoc
    [ ("momentum", Json.vec t.momentum); ("angular", Json.vec t.angular); ("energy", Json.rat t.energy) ]

let enclosure (low, high) = `Assoc [ ("low", totals low); ("high", totals high) ]

let event (m : Model.t) states (e : Replay.event) =
  match e with
  | Start s -> [ state m ~time:Rat.zero s ]
  | Step { number; index; among; time; taken; state } ->
    let rounded = Option.map (fun t -> ("rounded", totals (Lazy.force t))) taken.rounded in
    let after =
      match states with
      | All -> Option.to_list rounded @ [ ("state", State_json.state m (state ())) ]
      | Ends -> []
    in
    [
      `Assoc
        ([
          ("type", `String "transition");
          ("step", `Int number);
          ("choice", `Int index);
          ("of", `Int among);
          ("label", State_json.label m taken.label);
          ("rules", `List (List.map (fun r -> `String (Rule.id r)) taken.rules));
          ("time", Json.rat time);
        ]
          @ after);
    ]
  | Instant { offset; time; state } ->
    [
      `Assoc
        [
          ("type", `String "instant");
          ("offset", Json.rat offset);
          ("time", Json.rat time);
          ("state", State_json.state m state);
        ];
    ]
  | End { steps; time; ending = e; last; rounded } ->
    let last =
      match (states, last) with
      | Ends, Some s when steps > 0 -> [ state m ~time (s ()) ]
      | (All | Ends), _ -> []
    in
    last
    @ [
      `Assoc
        ([
          ("type", `String "end");
          ("steps", `Int steps);
          ("time", Json.rat time);
          ("ending", `String (ending e));
        ]
          @ why m e
          @ Option.to_list (Option.map (fun bounds -> ("rounded", enclosure bounds)) rounded));
    ]
