open Scc_exact
open Scc_data

(* Of each branch or choice the number of its function: few differ. *)
type numbered = { functions : Rational_function.t array; number : int array }

type t = {
  back : Backwards.t;
  probabilities : numbered;
  rewards : numbered;
  low : Rat.t;
  high : Rat.t;
}

type value = Finite of Rational_function.t | Infinite
type piece = { low : Algebraic.t; high : Algebraic.t; value : value }
type given_up = Solver of Exact_solver.given_up | Too_many of int | Interrupted
type found = { pieces : piece list; values : (Rat.t * Rat.t) list }
type stopped = { why : given_up; found : found }

module Functions = Hashtbl.Make (Rational_function)

let numbered count f =
  let known = Functions.create 16 and functions = Growable.create () in
  let number i =
    let f = f i in
    match Functions.find_opt known f with
    | Some n -> n
    | None ->
      let n = Growable.length functions in
      Functions.add known f n;
      Growable.push functions f;
      n
  in
  let number = Array.init count number in
  { functions = Array.init (Growable.length functions) (Growable.get functions); number }

let make back ~probability ~reward ~low ~high =
  let m = Backwards.mdp back in
  let probabilities = numbered (Mdp.branches m) probability in
  { back; probabilities; rewards = numbered (Mdp.choices m) reward; low; high }

let at_value { functions; number } v =
  let value f =
    match Rational_function.eval f v with
    | Some x -> x
    | None -> Scc_base.Bug.fail __POS__ "a pole within the range of the parameter"
  in
  let values = Array.map value functions in
  Array.map (Array.get values) number

let instance p v =
  let m = Backwards.mdp p.back in
  Backwards.with_mdp p.back
    (Mdp.with_numbers m ~probability:(at_value p.probabilities v) ~reward:(at_value p.rewards v))

(* {1 Degrees} *)

let degree q = Int.max 0 (Polynomial.degree q)

(* The functions of a choice, written over the least common denominator: its degree, that of the greatest
   numerator, and the denominator itself. *)
type over = { below : int; above : int; denominator : Polynomial.t }

let common functions =
  let join l f =
    let d = Rational_function.denominator f in
    fst (Polynomial.divide (Polynomial.mul l d) (Polynomial.gcd l d))
  in
  let denominator = Polynomial.primitive (List.fold_left join Polynomial.one functions) in
  let below = degree denominator in
  let above f =
    degree (Rational_function.numerator f) + below - degree (Rational_function.denominator f)
  in
  { below; above = List.fold_left (fun n f -> Int.max n (above f)) 0 functions; denominator }

let most { below; above; _ } = Int.max below above

(* Of all choices, each combination of functions once. *)
let degrees p =
  let m = Backwards.mdp p.back in
  let known = Hashtbl.create 16 in
  let of_choice c =
    let first = Mdp.first_branch m c and last = Mdp.first_branch m (c + 1) - 1 in
    let number i = p.probabilities.number.(first + i) in
    let branches = List.sort_uniq Int.compare (List.init (last - first + 1) number) in
    let key = (branches, p.rewards.number.(c)) in
    match Hashtbl.find_opt known key with
    | Some over -> over
    | None ->
      let functions = p.rewards.functions.(snd key) :: List.map (Array.get p.probabilities.functions) branches in
      let over = common functions in
      Hashtbl.add known key over;
      over
  in
  of_choice

(* A bound of the degree of a common denominator of the values of all nodes, and for each node how much higher that
   of its numerator over this denominator may be. *)
type bounds = { denominator : int; excess : int array }

(* The denominators that are not 1, each by its number. *)
let distinct_denominators overs =
  let add found (o : over) =
    if o.below = 0 || List.exists (Polynomial.equal o.denominator) found then found else o.denominator :: found
  in
  Array.of_list (List.rev (Array.fold_left add [] overs))

(* More of them count as if each node had its own. *)
let most_denominators = 32

(* The values of a component solve a system with polynomial coefficients, once each row is multiplied by its
   common denominator. By Cramer's rule its determinant has a degree of at most the sum of those of its rows, and
   is a denominator of its values over those of the components that it leads to. A node that does not lead back to
   itself adds its own denominator once to each path. *)
let bounds p (e : Equations.t) of_choice ~row =
  let m = Backwards.mdp p.back in
  let overs = Array.init e.size (fun v -> of_choice (Equations.choice e row.(v))) in
  let distinct = distinct_denominators overs in
  let few = Array.length distinct <= most_denominators in
  let count = if few then Array.length distinct else 0 in
  let times = Array.init e.size (fun _ -> Array.make count 0) in
  let excess = Array.make e.size 0 and cycles = ref 0 in
  let leads_back v =
    let c = Equations.choice e row.(v) in
    let rec from b =
      b < Mdp.first_branch m (c + 1) && (Equations.node_of e (Mdp.target m b) = v || from (b + 1))
    in
    from (Mdp.first_branch m c)
  in
  let entries v f =
    for i = Equations.first_entry e row.(v) to Equations.first_entry e (row.(v) + 1) - 1 do
      f (Equations.node e i)
    done
  in
  let component first last =
    let cyclic = last > first || leads_back first in
    let more = ref 0 and before = Array.make count 0 in
    for v = first to last do
      entries v (fun w ->
          if w < first then begin
            more := Int.max !more excess.(w);
            Array.iteri (fun l n -> before.(l) <- Int.max before.(l) n) times.(w)
          end);
      if cyclic then cycles := !cycles + most overs.(v)
      else begin
        more := !more + Int.max 0 (overs.(v).above - overs.(v).below);
        if not few then cycles := !cycles + overs.(v).below
        else
          Array.iteri
            (fun l d -> if Polynomial.equal d overs.(v).denominator then before.(l) <- before.(l) + 1)
            distinct
      end
    done;
    for v = first to last do
      excess.(v) <- !more;
      times.(v) <- before
    done
  in
  for k = 0 to Array.length e.parts - 2 do
    component e.parts.(k) (e.parts.(k + 1) - 1)
  done;
  let greatest l = Array.fold_left (fun n t -> Int.max n t.(l)) 0 times in
  let along = Array.mapi (fun l d -> if few then degree d * greatest l else 0) distinct in
  { denominator = Array.fold_left ( + ) !cycles along; excess }

(* {1 Samples} *)

exception Given_up of given_up

(* The fractions between 0 and 1, by increasing denominators. *)
let fractions () =
  let found = Growable.create () in
  let next = ref 2 in
  let rec nth i =
    if i < Growable.length found then Growable.get found i
    else begin
      let q = !next in
      incr next;
      for k = 1 to q - 1 do
        let k = Z.of_int k and q = Z.of_int q in
        if Z.equal (Z.gcd k q) Z.one then Growable.push found (Rat.make k q)
      done;
      nth i
    end
  in
  nth

(* What is known of a process with a problem: its equations at any value of the parameter. *)
type work = {
  p : t;
  problem : Solution.problem;
  effort : Effort.t;
  asked : int;
  of_choice : int -> over;
  fraction : int -> Rat.t;
  mutable kept : piece list;
  mutable single : (Rat.t * Rat.t) list;  (** least or greatest values, the last one first *)
}

let keep w v value = w.single <- (v, value) :: w.single

let most_samples = 20_000

let equations w v = Solution.equations (instance w.p v) w.problem ~asked:(Some (Int.equal w.asked))

let sample_point w i = Rat.add w.p.low (Rat.mul (Rat.sub w.p.high w.p.low) (w.fraction i))

let solver = function Ok x -> x | Error why -> raise (Given_up (Solver why))

(* Exact values of several functions at the points of samples, computed when they are first needed. *)
let sampled w compute =
  let found = Growable.create () in
  let rec nth i =
    if i < Growable.length found then Growable.get found i
    else begin
      if w.effort.interrupted () then raise (Given_up Interrupted);
      let v = sample_point w (Growable.length found) in
      Growable.push found (v, compute v);
      nth i
    end
  in
  nth

(* Two functions n/d and n'/d' are equal if n d' - n' d, of degree at most the greater sum below, has more roots.
   None of the denominators vanishes at a sample: values of the solver are finite, and those of the guess are
   compared. *)
let needed ~above ~below f =
  let n = degree (Rational_function.numerator f) and d = degree (Rational_function.denominator f) in
  1 + Int.max (above + d) (below + n)

(* The function number [j] of samples, whose numerator and denominator have at most these degrees. *)
let proved w sample j ~above ~below =
  let point i =
    let v, values = sample i in
    (v, values.(j))
  in
  let holds f count =
    let rec from i =
      i >= count || (let v, y = point i in Rational_function.passes f v y && from (i + 1))
    in
    from 0
  in
  let rec guess count =
    if count > most_samples then raise (Given_up (Too_many (above + below + 1)));
    let points = Array.init count point in
    match Interpolation.through ~interrupted:w.effort.interrupted points with
    | Some f ->
      let needed = needed ~above ~below f in
      if needed > most_samples then raise (Given_up (Too_many needed));
      if holds f needed then f else guess (2 * count)
    | None ->
      if w.effort.interrupted () then raise (Given_up Interrupted);
      guess (2 * count)
  in
  guess 8

(* {1 One scheduler} *)

let rows (e : Equations.t) = Equations.first_row e e.size
let is_chain (e : Equations.t) = rows e = e.size

(* The node of each row. *)
let nodes_of_rows (e : Equations.t) =
  let node = Array.make (rows e) 0 in
  for v = 0 to e.size - 1 do
    for r = Equations.first_row e v to Equations.first_row e (v + 1) - 1 do
      node.(r) <- v
    done
  done;
  node

(* The value of the asked node, and the gains of all rows that the scheduler does not take, as functions. *)
let functions w (e : Equations.t) ~row =
  let start = Equations.node_of e w.asked in
  let node = nodes_of_rows e in
  let others = List.filter (fun r -> row.(node.(r)) <> r) (List.init (rows e) Fun.id) in
  let others = Array.of_list others in
  let compute v =
    let e = equations w v in
    let value = solver (Exact_solver.evaluate e w.effort ~row) in
    if is_chain e then keep w v value.(start);
    let gain r = Rat.sub (Equations.row_sum e (Array.get value) r) value.(node.(r)) in
    Array.append [| value.(start) |] (Array.map gain others)
  in
  let sample = sampled w compute in
  let { denominator; excess } = bounds w.p e w.of_choice ~row in
  let value = proved w sample 0 ~above:(denominator + excess.(start)) ~below:denominator in
  let greatest = Array.fold_left Int.max 0 excess in
  let gain j r =
    let more = most (w.of_choice (Equations.choice e r)) in
    proved w sample (j + 1) ~above:(denominator + greatest + more) ~below:(denominator + more)
  in
  (value, List.mapi gain (Array.to_list others))

(* {1 All schedulers} *)

(* Where a gain changes its sign. Its denominator has no root within the range. *)
let changes w gain = Real_roots.changes (Rational_function.numerator gain) ~low:w.p.low ~high:w.p.high

(* The part around a value in which no gain changes its sign. [None] if a gain is 0 just there, and not
   everywhere: a scheduler that is best at this value may then be worse than another on both sides of it. *)
let stays w ~from ~until v gains =
  let near (l, h) root =
    if Algebraic.compare_rat root v < 0 then ((if Algebraic.compare root l > 0 then root else l), h)
    else (l, if Algebraic.compare root h < 0 then root else h)
  in
  let ties g =
    (not (Rational_function.equal g Rational_function.zero)) && Rational_function.passes g v Rat.zero
  in
  if List.exists ties gains then None
  else Some (List.fold_left (fun ends g -> List.fold_left near ends (changes w g)) (from, until) gains)

(* The piece around a value. A value at which a gain is 0 is followed by a smaller one. *)
let rec piece w ~from ~until v tries =
  let e = equations w v in
  let { Exact_solver.row; value } = solver (Exact_solver.solve e w.effort) in
  keep w v value.(Equations.node_of e w.asked);
  let value, gains = functions w e ~row in
  match stays w ~from ~until v gains with
  | Some (low, high) -> { low; high; value = Finite value }
  | None when tries > 0 -> piece w ~from ~until (Algebraic.between from (Algebraic.of_rat v)) (tries - 1)
  | None -> Scc_base.Bug.fail __POS__ "a scheduler that is best at one point alone"

(* What is left of the range, and pieces that were found, from the left. *)
type part = Left of Algebraic.t * Algebraic.t | Found of piece

let over w ~from ~until =
  let some low high = if Algebraic.compare low high < 0 then [ Left (low, high) ] else [] in
  let rec go parts found =
    match parts with
    | [] -> List.rev found
    | Found p :: rest -> go rest (p :: found)
    | Left (from, until) :: rest ->
      let p = piece w ~from ~until (Algebraic.between from until) 100 in
      w.kept <- p :: w.kept;
      go (some from p.low @ (Found p :: some p.high until) @ rest) found
  in
  go (some from until) []

let same a b =
  match (a.value, b.value) with
  | Finite f, Finite g -> Rational_function.equal f g
  | Infinite, Infinite -> true
  | Finite _, Infinite | Infinite, Finite _ -> false

let joined pieces =
  let add done_ p =
    match done_ with
    | last :: rest when same last p && Algebraic.equal last.high p.low -> { last with high = p.high } :: rest
    | _ -> p :: done_
  in
  List.rev (List.fold_left add [] pieces)

let solve (p : t) (problem : Solution.problem) effort ~asked =
  let whole value =
    Ok [ { low = Algebraic.of_rat p.low; high = Algebraic.of_rat p.high; value } ]
  in
  match problem.status asked with
  | Known x -> whole (Finite (Rational_function.constant x))
  | Elsewhere -> whole Infinite
  | Open -> (
      let fraction = fractions () and of_choice = degrees p in
      let w = { p; problem; effort; asked; of_choice; fraction; kept = []; single = [] } in
      let v = sample_point w 0 in
      try
        let e = equations w v in
        if is_chain e then whole (Finite (fst (functions w e ~row:(Array.init e.size (Equations.first_row e)))))
        else
          Ok (joined (over w ~from:(Algebraic.of_rat p.low) ~until:(Algebraic.of_rat p.high)))
      with Given_up why ->
        let by_place a b = Algebraic.compare a.low b.low in
        let pieces = joined (List.sort by_place w.kept) in
        Error { why; found = { pieces; values = List.rev w.single } })
