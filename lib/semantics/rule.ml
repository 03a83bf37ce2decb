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
  | Bounce
  | Time
  | Steer

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
  | Bounce -> "Bounce"
  | Time -> "Time"
  | Steer -> "Steer"

let all =
  [
    Pre; Weak; Strong; Sum; Def; Eps0; Time_behaviour; Weak_split; Strong_split; Bind; Bounce; Time; Steer;
  ]
