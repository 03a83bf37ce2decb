open Scc_exact
open Scc_calculus
open Scc_property

type t = { low : Rat.t option; high : Rat.t option; ends_only : bool }

let unknown = { low = None; high = None; ends_only = false }
let never_negative = { unknown with low = Some Rat.zero }

let both r =
  let*? low = r.low in
  let*? high = r.high in
  Some (low, high)

let is_unknown r = Option.is_none r.low && Option.is_none r.high
let is_point r = match both r with Some (low, high) -> Rat.equal low high | None -> false
let point x = { low = Some x; high = Some x; ends_only = true }
let from_to low high =
  { low = Some (Rat.of_int low); high = Some (Rat.of_int high); ends_only = high - low <= 1 }

(* {1 Arithmetic} *)

(* If one is a point, the other one's ends become the ends. *)
let keeps_ends a b = a.ends_only && b.ends_only && (is_point a || is_point b)
let neg a = { a with low = Option.map Rat.neg a.high; high = Option.map Rat.neg a.low }
let add a b =
  { low = Option.map2 Rat.add a.low b.low; high = Option.map2 Rat.add a.high b.high; ends_only = keeps_ends a b }

let at_least x r = match r.low with Some low -> Rat.compare low x >= 0 | None -> false
let is_above r = match r.low with Some low -> Rat.sign low > 0 | None -> false

(* Of numbers that are not both bounded something is known if each of them has only one sign. *)
let mul a b =
  let zero = Rat.zero in
  let of_positive a b =
    { unknown with low = Option.map2 Rat.mul a.low b.low; high = Option.map2 Rat.mul a.high b.high }
  in
  match (both a, both b) with
  | Some (al, ah), Some (bl, bh) ->
    let low, high = Rat.span (Rat.mul al bl) [ Rat.mul al bh; Rat.mul ah bl; Rat.mul ah bh ] in
    { low = Some low; high = Some high; ends_only = keeps_ends a b }
  | _ when at_least zero a && at_least zero b -> of_positive a b
  | _ when at_least zero (neg a) && at_least zero b -> neg (of_positive (neg a) b)
  | _ when at_least zero a && at_least zero (neg b) -> neg (of_positive a (neg b))
  | _ when at_least zero (neg a) && at_least zero (neg b) -> of_positive (neg a) (neg b)
  | _ -> unknown

let inverse b =
  let of_positive b =
    let one_over = Option.map (Rat.div Rat.one) in
    { b with low = Some (Option.value (one_over b.high) ~default:Rat.zero); high = one_over b.low }
  in
  if is_above b then of_positive b else if is_above (neg b) then neg (of_positive (neg b)) else unknown

let either a b =
  let low = Option.map2 Rat.min a.low b.low and high = Option.map2 Rat.max a.high b.high in
  let at_an_end x = Option.equal Rat.equal x low || Option.equal Rat.equal x high in
  let ends r = r.ends_only && at_an_end r.low && at_an_end r.high in
  { low; high; ends_only = Option.is_some low && Option.is_some high && ends a && ends b }

(* Both are true of a number. If no number is in both, there is no such case, and either of them will do. *)
let meet a b =
  let low = Option.merge Rat.max a.low b.low and high = Option.merge Rat.min a.high b.high in
  let same r = Option.equal Rat.equal r.low low && Option.equal Rat.equal r.high high in
  match (low, high) with
  | Some l, Some h when Rat.compare l h > 0 -> a
  | Some l, Some h when Rat.equal l h -> point l
  | _ -> { low; high; ends_only = a.ends_only && same a }

(* {1 Numbers} *)

let around x far = { unknown with low = Some (Rat.sub x far); high = Some (Rat.add x far) }
let up_to high = { never_negative with high = Some high }

(* By how fast bodies are: (law Ranges). *)
let of_motion (m : Model.t) (s : State.t) ~time =
  let squares = Scc_state_space.Pace.speeds m s ~horizon:time in
  let place i = Option.map (fun home -> State.centroid m (State.leaf_of home i)) (State.home s i) in
  let known of_speeds =
    Option.map (fun squares -> of_speeds (fun i -> squares.(i)) (fun i -> Rat.root squares.(i))) squares
  in
  let total f =
    let add (i, sum) (l : Model.leaf) = (i + 1, if l.fixed then sum else Rat.add sum (Rat.mul l.mass (f i))) in
    snd (Array.fold_left add (0, Rat.zero) m.leaves)
  in
  let far speed i = Rat.mul time (speed i) in
  function
  | Property.Position (axis, i) ->
    let*? x = place i in
    known (fun _ speed -> around (Vec.component axis x) (far speed i))
  | Distance2 (i, j) ->
    let*? x = place i in
    let*? y = place j in
    known (fun _ speed ->
        let apart = Rat.add (Rat.root (Vec.norm2 (Vec.sub x y))) (Rat.add (far speed i) (far speed j)) in
        up_to (Rat.mul apart apart))
  | Velocity (_, i) -> known (fun _ speed -> around Rat.zero (speed i))
  | Speed2 i -> known (fun square _ -> up_to (square i))
  | Momentum _ -> known (fun _ speed -> around Rat.zero (total speed))
  | Energy -> known (fun square _ -> up_to (Rat.mul Rat.half (total square)))
  | Bonds _ | Size _ | Processes | Spin _ | Spin2 _ | Angular _ | Time | Parameter _ -> None

(* Bonds make trees, or two leaves have one bond at most (Def-5.2, I-37); and each leaf is in one process or in
   none (WellFormed). *)
let of_quantity (m : Model.t) ~from ~time =
  let leaves = Array.length m.leaves in
  let of_motion = Option.fold ~none:(fun _ -> None) ~some:(of_motion m ~time) from in
  fun (q : Property.quantity) ->
    match (of_motion q, q) with
    | Some range, _ -> range
    | None, Bonds (_, None) ->
      from_to 0 (match m.bonds with Acyclic -> Int.max 0 (leaves - 1) | Cyclic -> leaves * (leaves - 1) / 2)
    | None, Bonds (_, Some _) -> from_to 0 1
    | None, Size _ ->
      from_to 0 (Array.fold_left (fun n (l : Model.leaf) -> n + Array.length l.parts) 0 m.leaves)
    | None, Processes -> from_to 0 leaves
    | None, Time -> point time
    | None, (Speed2 _ | Spin2 _ | Distance2 _ | Energy) -> never_negative
    | None, (Position _ | Velocity _ | Spin _ | Momentum _ | Angular _ | Parameter _) -> unknown

(* [given]: the ranges of terms of which more is known here, by the conditions around, the innermost first. *)
let rec number quantity ~given (n : Property.num) =
  let range = number quantity ~given in
  match List.find_opt (fun (term, _) -> Formula.equal_num term n) given with
  | Some (_, known) -> known
  | None -> (
      match n with
      | Const c -> point c
      | Quantity q -> quantity q
      | Count props -> from_to 0 (List.length props)
      | Neg a -> neg (range a)
      | Add (a, b) -> add (range a) (range b)
      | Sub (a, b) -> add (range a) (neg (range b))
      | Mul (a, b) -> mul (range a) (range b)
      | Div (a, b) -> mul (range a) (inverse (range b))
      | If (p, a, b) ->
        let under p n = number quantity ~given:(assumed quantity given p) n in
        either (under p a) (under (Formula.negate p) b))

(* What is known where [p] is true as well. *)
and assumed quantity given : Property.prop -> _ = function
  | And ps -> List.fold_left (assumed quantity) given ps
  | Compare (relation, a, b) -> (
      let of_a = number quantity ~given a and of_b = number quantity ~given b in
      let at_most r = { unknown with high = r.high } and at_least r = { unknown with low = r.low } in
      let less (a, of_a) (b, of_b) = (a, meet of_a (at_most of_b)) :: (b, meet of_b (at_least of_a)) :: given in
      match relation with
      | Lt | Le -> less (a, of_a) (b, of_b)
      | Gt | Ge -> less (b, of_b) (a, of_a)
      | Eq -> (a, meet of_a of_b) :: (b, meet of_b of_a) :: given
      | Ne -> given)
  | Not _ | Bool _ | Fact _ | Or _ -> given

let of_number m ~from ~time n = number (of_quantity m ~from ~time) ~given:[] n
