open Scc_exact

(* {1 Sets} *)

type interval = { low : Algebraic.t; low_included : bool; high : Algebraic.t; high_included : bool }
type set = { first : bool; cuts : (Algebraic.t * bool * bool) list }

let everywhere first = { first; cuts = [] }

(* Without points at which nothing changes. *)
let reduced { first; cuts } =
  let add (before, kept) ((_, at, after) as cut) =
    if Bool.equal before at && Bool.equal at after then (before, kept) else (after, cut :: kept)
  in
  { first; cuts = List.rev (snd (List.fold_left add (first, []) cuts)) }

let combine f a b =
  let rec go x y some others done_ =
    match (some, others) with
    | [], [] -> List.rev done_
    | (p, at, after) :: rest, [] -> go after y rest [] ((p, f at y, f after y) :: done_)
    | [], (p, at, after) :: rest -> go x after [] rest ((p, f x at, f x after) :: done_)
    | (p, at, after) :: rest, (q, at', after') :: rest' -> (
        match Algebraic.compare p q with
        | 0 -> go after after' rest rest' ((p, f at at', f after after') :: done_)
        | c when c < 0 -> go after y rest others ((p, f at y, f after y) :: done_)
        | _ -> go x after' some rest' ((q, f x at', f x after') :: done_))
  in
  reduced { first = f a.first b.first; cuts = go a.first b.first a.cuts b.cuts [] }

let complement a = combine (fun x _ -> not x) a (everywhere true)

let intervals ~low ~high set =
  let low = Algebraic.of_rat low and high = Algebraic.of_rat high in
  let close start high high_included done_ =
    match start with
    | None -> done_
    | Some (low, low_included) -> { low; low_included; high; high_included } :: done_
  in
  let rec go start cuts done_ =
    match cuts with
    | [] -> List.rev (close start high false done_)
    | (p, at, after) :: rest -> (
        match (start, at, after) with
        | Some _, true, true -> go start rest done_
        | Some _, _, true -> go (Some (p, false)) rest (close start p false done_)
        | Some _, _, false -> go None rest (close start p at done_)
        | None, _, true -> go (Some (p, at)) rest done_
        | None, true, false -> go None rest (close (Some (p, true)) p true done_)
        | None, false, false -> go None rest done_)
  in
  go (if set.first then Some (low, false) else None) set.cuts []

(* {1 Pieces} *)

let inside (piece : Parametric.piece) points =
  List.filter (fun x -> Algebraic.compare piece.low x < 0 && Algebraic.compare x piece.high < 0) points

(* A rational number in each part of a piece between points. *)
let samples (piece : Parametric.piece) points =
  let rec go from = function
    | [] -> [ Algebraic.between from piece.high ]
    | x :: rest -> Algebraic.between from x :: go x rest
  in
  go piece.low points

let satisfies (relation : Answer.relation) c =
  match relation with Less -> c < 0 | At_most -> c <= 0 | At_least_so -> c >= 0 | More -> c > 0

let value f x =
  match Rational_function.eval f x with
  | Some y -> y
  | None -> Scc_base.Bug.fail __POS__ "a pole within the range of the parameter"

let where ~low ~high (bound : Answer.bound) pieces =
  let holds c = satisfies bound.relation c in
  (* The cuts of a piece without those at its ends, and its first part. *)
  let of_piece (piece : Parametric.piece) =
    match piece.value with
    | Infinite -> everywhere (holds 1)
    | Finite f ->
      let n = Rational_function.numerator f and d = Rational_function.denominator f in
      let difference = Polynomial.sub n (Polynomial.scale bound.than d) in
      let sign x = Rat.compare (value f x) bound.than in
      if Polynomial.is_zero difference then everywhere (holds 0)
      else
        let roots = inside piece (Real_roots.all difference ~low ~high) in
        (match samples piece roots with
         | [] -> Scc_base.Bug.fail __POS__ "a piece without numbers"
         | first :: rest ->
           { first = holds (sign first); cuts = List.map2 (fun x v -> (x, holds 0, holds (sign v))) roots rest })
  in
  (* Functions have one value where their pieces meet. *)
  let at_end (piece : Parametric.piece) x =
    match piece.value with
    | Infinite -> holds 1
    | Finite f ->
      let n = Rational_function.numerator f and d = Rational_function.denominator f in
      let difference = Polynomial.sub n (Polynomial.scale bound.than d) in
      let positive = Algebraic.sign_at d x in
      holds (positive * Algebraic.sign_at difference x)
  in
  let rec go (pieces : Parametric.piece list) =
    match pieces with
    | [] -> []
    | [ last ] -> (of_piece last).cuts
    | piece :: (next :: _ as rest) ->
      (of_piece piece).cuts @ ((next.low, at_end piece next.low, (of_piece next).first) :: go rest)
  in
  match pieces with
  | [] -> Scc_base.Bug.fail __POS__ "no piece"
  | first :: _ -> reduced { first = (of_piece first).first; cuts = go pieces }

(* {1 Shape} *)

type trend = Rises | Falls | Constant

let same_trend (a : trend) b =
  match (a, b) with
  | Rises, Rises | Falls, Falls | Constant, Constant -> true
  | (Rises | Falls | Constant), _ -> false

let trends ~low ~high pieces =
  let of_piece (piece : Parametric.piece) =
    match piece.value with
    | Infinite -> None
    | Finite f ->
      let slope = Rational_function.slope f in
      if Polynomial.is_zero slope then Some [ (piece.low, piece.high, Constant) ]
      else
        let turns = inside piece (Real_roots.changes slope ~low ~high) in
        let ends = (piece.low :: turns) @ [ piece.high ] in
        (* A sample may be a zero without a change of sign; there are finitely many. *)
        let rec sign a v =
          match Polynomial.sign_at slope v with 0 -> sign a (Algebraic.between a (Algebraic.of_rat v)) | s -> s
        in
        let rec go ends samples =
          match (ends, samples) with
          | a :: (b :: _ as rest), v :: others ->
            (a, b, if sign a v > 0 then Rises else Falls) :: go rest others
          | _ -> []
        in
        Some (go ends (samples piece turns))
  in
  let join done_ (a, b, t) =
    match done_ with (c, _, u) :: rest when same_trend t u -> (c, b, t) :: rest | _ -> (a, b, t) :: done_
  in
  let all = List.map of_piece pieces in
  if List.exists Option.is_none all then []
  else List.rev (List.fold_left join [] (List.concat (List.filter_map Fun.id all)))

type level = Exactly of Rat.t | Between of Rat.t * Rat.t | Unbounded
type extreme = { at : Algebraic.t list; attained : bool; level : level }

(* The values of a polynomial between two numbers are between these. *)
let enclosed p low high =
  let add (a, b) (c : Rat.t) =
    let products = [ Rat.mul a high; Rat.mul b low; Rat.mul b high ] in
    let least, greatest = Rat.span (Rat.mul a low) products in
    (Rat.add least c, Rat.add greatest c)
  in
  List.fold_left add (Rat.zero, Rat.zero) (List.rev (Polynomial.coefficients p))

let near = Rat.make Z.one (Z.of_string "1000000000000")

(* Bounds of the value of a function at an irrational point, refined until they are close. *)
let rec level_at f x width =
  let low, high = Algebraic.enclose x ~width in
  let finer () = level_at f x (Rat.mul width (Rat.make Z.one (Z.of_int 256))) in
  let n, n' = enclosed (Rational_function.numerator f) low high in
  let d, d' = enclosed (Rational_function.denominator f) low high in
  if Rat.sign d * Rat.sign d' <= 0 then finer ()
  else
    let least, greatest = Rat.span (Rat.div n d) [ Rat.div n d'; Rat.div n' d; Rat.div n' d' ] in
    if Rat.compare (Rat.sub greatest least) near < 0 then (least, greatest) else finer ()

let level f x =
  match Algebraic.to_rat x with
  | Some r -> (
      match Rational_function.eval f r with Some y -> Exactly y | None -> Unbounded)
  | None ->
    let low, high = level_at f x near in
    Between (low, high)

let function_at (pieces : Parametric.piece list) x =
  let covers (p : Parametric.piece) = Algebraic.compare p.low x <= 0 && Algebraic.compare x p.high <= 0 in
  match (List.find covers pieces).value with
  | Finite f -> f
  | Infinite -> Scc_base.Bug.fail __POS__ "an infinite value has no shape"

(* Only at points that trends leave: where falling comes before rising, and at ends. *)
let candidates trends ~sinks =
  let before, after = if sinks then (Falls, Rises) else (Rises, Falls) in
  let rec turns = function
    | (_, x, t) :: ((_, _, u) :: _ as rest) ->
      let here = (same_trend t before || same_trend t Constant) && (same_trend u after || same_trend u Constant) in
      (if here then [ (x, true) ] else []) @ turns rest
    | [ _ ] | [] -> []
  in
  match trends with
  | [] -> []
  | (first, _, t) :: _ ->
    let _, last, u = List.nth trends (List.length trends - 1) in
    (if same_trend t after then [ (first, false) ] else [])
    @ turns trends
    @ if same_trend u before then [ (last, false) ] else []

let ends = function Exactly x -> Some (x, x) | Between (a, b) -> Some (a, b) | Unbounded -> None

let best pieces candidates ~less =
  let leveled = List.map (fun (x, attained) -> (x, attained, level (function_at pieces x) x)) candidates in
  (* The outermost bound that every best one has to reach. *)
  let surely_better a b =
    match (ends a, ends b) with
    | None, _ | _, None -> false
    | Some (a, a'), Some (b, b') -> if less then Rat.compare a' b < 0 else Rat.compare a b' > 0
  in
  let unbounded = List.filter (fun (_, _, l) -> l = Unbounded) leveled in
  let left =
    match unbounded with
    | _ :: _ when not less -> unbounded
    | _ ->
      let finite = List.filter (fun (_, _, l) -> l <> Unbounded) leveled in
      List.filter (fun (_, _, l) -> not (List.exists (fun (_, _, m) -> surely_better m l) finite)) finite
  in
  match left with
  | [] -> None
  | (_, _, level) :: _ ->
    let attained = List.exists (fun (_, attained, _) -> attained) left in
    Some { at = List.map (fun (x, _, _) -> x) left; attained; level }

type shape = {
  trends : (Algebraic.t * Algebraic.t * trend) list;
  extremes : (extreme * extreme) option;
}

let shape ~low ~high pieces =
  match trends ~low ~high pieces with
  | [] -> None
  | [ (_, _, Constant) ] as trends -> Some { trends; extremes = None }
  | trends ->
    let least = best pieces (candidates trends ~sinks:true) ~less:true in
    let greatest = best pieces (candidates trends ~sinks:false) ~less:false in
    Some { trends; extremes = (match (least, greatest) with Some a, Some b -> Some (a, b) | _ -> None) }
