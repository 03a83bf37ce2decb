type t =
  | Pre
  | Weak
  | Strong
  | Sum
  | Def
  | Eps0
  | Time_behaviour
  | Weak_split
  | Strong_split
  | Bind
  | Close
  | Bounce
  | Absorb
  | Time
  | Steer
  | Draw
  | Lot
  | Turn
  | Round

let id = function
  | Pre -> "Pre"
  | Weak -> "Weak"
  | Strong -> "Strong"
  | Sum -> "Sum"
  | Def -> "Def"
  | Eps0 -> "Eps0"
  | Time_behaviour -> "TimeBehaviour"
  | Weak_split -> "WeakSplit"
  | Strong_split -> "StrongSplit"
  | Bind -> "Bind"
  | Close -> "Close"
  | Bounce -> "Bounce"
  | Absorb -> "Absorb"
  | Time -> "Time"
  | Steer -> "Steer"
  | Draw -> "Draw"
  | Lot -> "Lot"
  | Turn -> "Turn"
  | Round -> "Round"

let all =
  [
    Pre; Weak; Strong; Sum; Def; Eps0; Time_behaviour; Weak_split; Strong_split; Bind; Close; Bounce; Absorb; Time;
    Steer; Draw; Lot; Turn; Round;
  ]

let of_model (m : Scc_calculus.Model.t) =
  let can = function
    | Close -> Scc_calculus.Model.closes_rings m
    | Turn -> Option.is_some m.rigid
    | Round -> Scc_calculus.Model.has_turns m
    | Absorb -> Scc_calculus.Model.absorbs m
    | Draw -> Scc_calculus.Model.draws m
    | Lot -> m.lots
    | _ -> true
  in
  List.filter can all
