open Scc_exact
open Scc_chance
open Decisions

type parameter = { low : Rat.t; high : Rat.t; drawn : int -> Rational_function.t option array option }
type reason = Interrupted | Unknown of string
type failure = { reason : reason; found : Parametric.found }
type 'a result = ('a, failure) Stdlib.result

let nothing : Parametric.found = { pieces = []; values = [] }
let without_any reason = Error { reason; found = nothing }

(* {1 The process with functions} *)

(* Each target once, increasing, as in an MDP. *)
let merged branches =
  let add all (t, f) =
    match all with
    | (u, g) :: rest when Int.equal t u -> (u, Rational_function.add g f) :: rest
    | _ -> (t, f) :: all
  in
  List.rev (List.fold_left add [] (List.stable_sort (fun (t, _) (u, _) -> Int.compare t u) branches))

let function_of k (p : place) branch =
  match branch.way with
  | Move (Edge i) -> (
      match k.drawn p.node with
      | Some functions -> Option.value functions.(i) ~default:Rational_function.one
      | None -> Rational_function.one)
  | Move (Flow _) | During _ | Nowhere -> Rational_function.one

(* Branches and choices are numbered as {!Decisions.build} does. *)
let with_functions k built ~choices ~low ~high =
  let probabilities = Scc_data.Growable.create () and rewards = Scc_data.Growable.create () in
  let earned p sum b =
    if Rat.sign b.reward = 0 then sum
    else Rational_function.(add sum (mul (function_of k p b) (constant b.reward)))
  in
  let add_choice p branches =
    List.map (fun b -> (number built b.next, function_of k p b)) branches
    |> merged
    |> List.iter (fun (_, f) -> Scc_data.Growable.push probabilities f);
    Scc_data.Growable.push rewards (List.fold_left (earned p) Rational_function.zero branches)
  in
  for _ = 1 to 2 do
    Scc_data.Growable.push probabilities Rational_function.one;
    Scc_data.Growable.push rewards Rational_function.zero
  done;
  for i = 0 to Scc_data.Growable.length built.places - 1 do
    let p = Scc_data.Growable.get built.places i in
    List.iter (add_choice p) (choices p)
  done;
  fun back ->
    Parametric.make back
      ~probability:(Scc_data.Growable.get probabilities)
      ~reward:(Scc_data.Growable.get rewards) ~low ~high

let reason (why : Parametric.given_up) =
  match why with
  | Solver Too_long -> Unknown "the numbers of its values become too long"
  | Solver Too_much -> Unknown "computing its values takes too many steps"
  | Solver Interrupted | Interrupted -> Interrupted
  | Too_many n ->
    Unknown (Printf.sprintf "its function may have so high a degree that %d values would be needed" n)

let solve e k built ~choices problem =
  let until = until built in
  let p = with_functions k built ~choices ~low:k.low ~high:k.high (Qualitative.backwards until) in
  match built.asked with
  | [ start ] -> (
      match Parametric.solve p (problem until) (Eval.effort e) ~asked:start with
      | Ok pieces -> Ok pieces
      | Error { why; found } -> Error { reason = reason why; found })
  | _ -> Scc_base.Bug.fail __POS__ "a value from one place"

let map_pieces f (pieces : Parametric.piece list) =
  let of_piece (p : Parametric.piece) =
    match p.value with Finite g -> { p with value = Parametric.Finite (f g) } | Infinite -> p
  in
  List.map of_piece pieces

(* A function of the value, on what was found of it, too. *)
let map f solved : Parametric.piece list result =
  let at_value (x, y) =
    Option.map (fun z -> (x, z)) (Rational_function.to_constant (f (Rational_function.constant y)))
  in
  match solved with
  | Ok pieces -> Ok (map_pieces f pieces)
  | Error { reason; found = { pieces; values } } ->
    Error { reason; found = { pieces = map_pieces f pieces; values = List.filter_map at_value values } }

(* {1 Values} *)

let unknown = Unknown "not all of what it depends on is known"

let rec has_chance (f : Timed_formula.t) =
  let of_quantifier : Timed_formula.quantifier -> bool = function Chance _ -> true | All | Exists -> false in
  match f with
  | Predicate _ -> false
  | Not f -> has_chance f
  | And fs | Or fs -> List.exists has_chance fs
  | Next (q, f) | Finally (q, _, f) | Globally (q, _, f) -> of_quantifier q || has_chance f
  | Until (q, _, f, g) -> of_quantifier q || has_chance f || has_chance g

(* {!Eval} has the truth of a probability at one value of the parameter, which says nothing of the others. *)
let within_another = Unknown "a probability within another operator may hold for some values alone"

let of_operands fs found = if List.exists has_chance fs then without_any within_another else found ()

let probability e k side f =
  match Eval.as_until e f with
  | None -> Scc_base.Bug.fail __POS__ "a probability of what is no until"
  | Some (u, flipped) ->
    of_operands [ u.left; u.right ] @@ fun () ->
    let side = if flipped then Timed_formula.other_side side else side in
    let left = Eval.value e u.left and right = Eval.value e u.right in
    let question generous (f, g) =
      let q = { graph = Eval.graph e; side; bound = u.bound; f; g; generous } in
      let w = window q in
      let choices = choices q w in
      (choices, build ~choices [ next q w (place w 0 Rat.zero) ])
    in
    let choices, built = question false (left.lower, right.lower) in
    let _, otherwise = question true (left.upper, right.upper) in
    (* What is not known does not matter if it makes no difference. *)
    if not (same_process built otherwise) then without_any unknown
    else
      let problem until = Reach.problem until (direction side) in
      let complement = map (fun g -> Rational_function.(sub one g)) in
      let solved = solve e k built ~choices problem in
      if flipped then complement solved else solved

let operands (what : Expectation.what) =
  match what with Time_until g | Counts_until (_, g) -> [ g ] | Value_at _ -> []

let mean e k side what =
  of_operands (operands what) @@ fun () ->
  match Expectation.process e side what with
  | Error why -> without_any (Unknown why)
  | Ok { choices; built; added } ->
    let problem until = Reward.problem until (direction side) in
    map (fun g -> Rational_function.(add g (constant added))) (solve e k built ~choices problem)

(* {1 Tests} *)

let rec where e k ~probability (f : Timed_formula.t) =
  match f with
  | Not f -> Result.map Dependence.complement (where e k ~probability f)
  | And fs -> all e k ~probability ( && ) true fs
  | Or fs -> all e k ~probability ( || ) false fs
  | Until (Chance c, _, _, _) | Finally (Chance c, _, _) | Globally (Chance c, _, _) -> test k ~probability c f
  | _ when has_chance f -> without_any within_another
  | _ -> (
      match Eval.truth e f (Positions.start 0) with
      | Some truth -> Ok (Dependence.everywhere truth)
      | None -> without_any unknown)

and all e k ~probability connect neutral fs =
  let add found f =
    let* found = found in
    Result.map (Dependence.combine connect found) (where e k ~probability f)
  in
  List.fold_left add (Ok (Dependence.everywhere neutral)) fs

and test k ~probability (c : Timed_formula.chance) f =
  Result.map (Dependence.where ~low:k.low ~high:k.high c.test) (probability c.side f)
