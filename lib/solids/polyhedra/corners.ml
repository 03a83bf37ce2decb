open Scc_exact
module Keys = Set.Make (String)

type t = { point : Rat.t array; tight : int list; determinant : Z.t; slopes : Rat.t array -> Rat.t list }

let columns = 2

(* {1 Moved outwards}

   Constraint number k is moved outwards by e_k, where each is infinitely less than the one before it in an order
   of the constraints. In a dictionary the slack of a row is then more than 0 by denominator * e_k for its own k,
   and by
   - row.(2 + c) * e_k for the k of each column. *)

let shift (t : Tableau.t) column_of r v =
  if t.basic.(r) = v then t.denominator
  else match column_of.(v) with -1 -> Z.zero | c -> Z.neg t.rows.(r).(columns + c)

let column_of (t : Tableau.t) =
  let columns = Array.make (Array.length t.kinds) (-1) in
  Array.iteri (fun c v -> columns.(v) <- c) t.cobasic;
  columns

(* Of two rows that limit the column the one that does so sooner. *)
let sooner (t : Tableau.t) order column_of c r s =
  let size r = Z.abs t.rows.(r).(columns + c) in
  let against x y = Z.compare (Z.mul x (size s)) (Z.mul y (size r)) in
  let rec by_shifts i =
    let v = order.(i) in
    match against (shift t column_of r v) (shift t column_of s v) with 0 -> by_shifts (i + 1) | by -> by < 0
  in
  match against t.rows.(r).(0) t.rows.(s).(0) with 0 -> by_shifts 0 | by -> by < 0

let is_slack (t : Tableau.t) v = v >= t.dimension

(* The row at which the way along the edge ends on which the constraint of a column is not tight. *)
let limiting (t : Tableau.t) order column_of c =
  let best = ref (-1) in
  let look r row =
    if is_slack t t.basic.(r) && Z.sign row.(columns + c) < 0 && (!best < 0 || sooner t order column_of c r !best)
    then best := r
  in
  Array.iteri look t.rows;
  if !best < 0 then Scc_base.Bug.fail __POS__ "an edge without an end";
  !best

(* {1 All corners} *)

(* The constraints that are tight, the one of a column replaced by another one. *)
let key (t : Tableau.t) ~without ~with_ =
  let bits = Bytes.make ((Array.length t.kinds + 7) / 8) '\000' in
  let put v =
    let byte = Char.code (Bytes.get bits (v / 8)) in
    Bytes.set bits (v / 8) (Char.chr (byte lor (1 lsl (v mod 8))))
  in
  Array.iteri (fun c v -> put (if c = without then with_ else v)) t.cobasic;
  Bytes.to_string bits

let corner (t : Tableau.t) =
  let point = Array.make t.dimension Rat.zero in
  let row_of = Array.make t.dimension 0 in
  let place r v =
    if not (is_slack t v) then begin
      point.(v) <- Rat.make t.rows.(r).(0) t.denominator;
      row_of.(v) <- r
    end
  in
  Array.iteri place t.basic;
  let slopes objective =
    let along c _ =
      let add sum a r =
        if Rat.sign a = 0 then sum else Rat.sub sum (Rat.mul a (Rat.make t.rows.(r).(columns + c) t.denominator))
      in
      let sum = ref Rat.zero in
      Array.iteri (fun i a -> sum := add !sum a row_of.(i)) objective;
      !sum
    in
    Array.to_list (Array.mapi along t.cobasic)
  in
  let tight = List.map (fun v -> v - t.dimension) (Array.to_list t.cobasic) in
  { point; tight; determinant = t.denominator; slopes }

let tableau p =
  let add t c =
    match Tableau.add t (Constraint.closed c) with
    | Some t -> t
    | None -> Scc_base.Bug.fail __POS__ "the closure of something is empty"
  in
  let t = List.fold_left add (Tableau.universe (Polyhedron.dimension p)) (Polyhedron.constraints p) in
  let t = Tableau.cornered t in
  if Array.exists (fun v -> not (is_slack t v)) t.cobasic then Scc_base.Bug.fail __POS__ "no bounded polyhedron";
  t

(* With slacks that are basic first in the order, the first dictionary stays feasible when all is moved. *)
let order_of (t : Tableau.t) =
  Array.of_list (List.filter (is_slack t) (Array.to_list t.basic) @ Array.to_list t.cobasic)

let fold ~most f start p =
  let first = tableau p in
  let order = order_of first in
  let seen = ref (Keys.singleton (key first ~without:(-1) ~with_:0)) and count = ref 1 in
  let rec visit result = function
    | [] -> Some result
    | _ :: _ when !count > most -> None
    | (t : Tableau.t) :: waiting ->
      let column_of = column_of t in
      let neighbour waiting c =
        let r = limiting t order column_of c in
        let key = key t ~without:c ~with_:t.basic.(r) in
        if Keys.mem key !seen then waiting
        else begin
          seen := Keys.add key !seen;
          incr count;
          Tableau.pivot t r c :: waiting
        end
      in
      let waiting = List.fold_left neighbour waiting (List.init (Array.length t.cobasic) Fun.id) in
      visit (f result (corner t)) waiting
  in
  visit start [ first ]
