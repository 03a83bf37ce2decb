open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_graph_search

type 'a bound = Unbounded | Default of 'a | Given of 'a

type t = {
  depth : int bound;
  time : Rat.t bound;
  states : int bound;
  seconds : float bound;
  memory : int bound;
  room : int option;
  instant : int bound;
  bits : int bound;
  shared : bool;
  drawing : int option;
}

let default =
  {
    depth = Unbounded;
    time = Unbounded;
    states = Unbounded;
    seconds = Unbounded;
    memory = Unbounded;
    room = None;
    instant = Default 10_000;
    bits = Default 100_000;
    shared = false;
    drawing = None;
  }

let value = function
  | Unbounded -> None
  | Default v | Given v -> Some v

let limits b ~horizon : Limits.t =
  {
    depth = value b.depth;
    time = Option.merge Rat.min (value b.time) horizon;
    instant = value b.instant;
    states = value b.states;
    bits = value b.bits;
  }

type cause = Bound of Verdict.truncation | Fault of Scc_base.Diag.t | Early

let truncation bound make : Verdict.truncation =
  match bound with
  | Given v -> { limit = make v; origin = By_user }
  | Default v -> { limit = make v; origin = By_default }
  | Unbounded -> Scc_base.Bug.fail __POS__ "a bound that is off was met"

let stopped b (stop : Limits.stop) =
  match stop with
  | Seconds ->
    let t = truncation b.seconds (fun s -> Verdict.Seconds s) in
    if b.shared then { t with origin = By_share } else t
  | Memory -> (
      match b.room with
      | Some w -> { limit = Memory w; origin = By_system }
      | None -> truncation b.memory (fun w -> Verdict.Memory w))
  | Interrupted -> { limit = Interrupted; origin = By_user }

(* The bound of time is the properties' own when theirs is the lesser. *)
let time b horizon : Verdict.truncation =
  match (horizon, value b.time) with
  | Some h, Some t when Rat.compare t h <= 0 -> truncation b.time (fun t -> Verdict.Time t)
  | Some h, _ -> { limit = Time h; origin = By_property }
  | None, _ -> truncation b.time (fun t -> Verdict.Time t)

let dead_end (d : Scc_base.Diag.t) =
  {
    d with
    severity = Warning;
    hint = Some "runs end there: the model is given up, and the calculus says nothing of what follows";
  }

let long_number (model : Model.t) state ~depth =
  let { Length.quantity; leaf; bits } = Length.longest state in
  let whose = Option.fold ~none:"" ~some:(fun l -> Printf.sprintf " of `%s`" model.leaves.(l).name) leaf in
  let cure =
    match quantity with
    | Spin | Orientation | Angular_momentum -> "`round orientation 2^-k` keeps numbers short"
    | Position | Velocity | Clock ->
      "`round velocity 2^-k`, or `round(e, q)` in a law of motion, keeps numbers short"
  in
  Scc_base.Diag.warning Scc_base.Code.long_number Scc_base.Span.none ~hint:(cure ^ "; `--bits N` lets them grow")
    "the %s%s takes %d bits after %d transitions, and what follows is not explored" (Length.name quantity) whose
    bits depth

let dead_ends context =
  let warning f = dead_end (Transition.diagnostic (Scc_state_space.Network_lts.model context) f) in
  List.sort_uniq Scc_base.Diag.compare (List.map warning (Scc_state_space.Network_lts.given_up context))

let cause b model ~horizon (r : _ Explore.reason) =
  match r with
  | Depth -> Bound (truncation b.depth (fun n -> Verdict.Depth n))
  | Time -> Bound (time b horizon)
  | Instant -> Bound (truncation b.instant (fun n -> Verdict.Instant n))
  | States ->
    let of_number states =
      match b.drawing with Some bodies -> Verdict.Draws { states; bodies } | None -> States states
    in
    Bound (truncation b.states of_number)
  | Bits -> Bound (truncation b.bits (fun n -> Verdict.Bits n))
  | Seconds -> Bound (stopped b Seconds)
  | Memory -> Bound (stopped b Memory)
  | Interrupted -> Bound (stopped b Interrupted)
  | Stopped -> Early
  | Fault f -> Fault (Transition.diagnostic model f)
