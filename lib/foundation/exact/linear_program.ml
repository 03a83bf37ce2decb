(* A tableau: of each row the coefficients of the n variables, those of one artificial variable for each row, and
   the right side; and which variable is basic in it. The last row has the reduced costs, and minus the cost. *)
type tableau = { n : int; rows : Rat.t array array; basic : int array }

let height t = Array.length t.basic
let right row = row.(Array.length row - 1)

let subtract row factor other =
  if Rat.sign factor <> 0 then
    Array.iteri (fun j x -> if Rat.sign x <> 0 then row.(j) <- Rat.sub row.(j) (Rat.mul factor x)) other

let pivot t r c =
  let by = t.rows.(r).(c) in
  let row = Array.map (fun x -> Rat.div x by) t.rows.(r) in
  t.rows.(r) <- row;
  Array.iteri (fun k other -> if k <> r then subtract other other.(c) row) t.rows;
  t.basic.(r) <- c

let find_first condition n =
  let rec from i = if i >= n then None else if condition i then Some i else from (i + 1) in
  from 0

(* The row that limits how far a variable can grow; of several that whose basic variable is the first. *)
let limiting t c =
  let ratio r = Rat.div (right t.rows.(r)) t.rows.(r).(c) in
  let better r s =
    let order = Rat.compare (ratio r) (ratio s) in
    order < 0 || (order = 0 && t.basic.(r) < t.basic.(s))
  in
  let consider best r =
    if Rat.sign t.rows.(r).(c) <= 0 then best
    else match best with Some s when not (better r s) -> best | Some _ | None -> Some r
  in
  List.fold_left consider None (List.init (height t) Fun.id)

(* Bland's rule: the first variable that lowers the cost. *)
let rec improve t =
  let costs = t.rows.(height t) in
  match find_first (fun j -> Rat.sign costs.(j) < 0) t.n with
  | None -> ()
  | Some c -> (
      match limiting t c with
      | None -> Scc_base.Bug.fail __POS__ "a linear program without bound"
      | Some r ->
        pivot t r c;
        improve t)

(* An artificial variable that is basic at 0 gives way, or its row says nothing. *)
let drive_out t r =
  if t.basic.(r) >= t.n then
    Option.iter (pivot t r) (find_first (fun j -> Rat.sign t.rows.(r).(j) <> 0) t.n)

let least rows right_sides ~cost =
  let m = Array.length rows and n = Array.length cost in
  let start r row =
    let artificial = Array.init m (fun k -> if k = r then Rat.one else Rat.zero) in
    Array.concat [ row; artificial; [| right_sides.(r) |] ]
  in
  let tableau = Array.mapi start rows in
  let costs = Array.make (n + m + 1) Rat.zero in
  Array.iter (subtract costs Rat.one) tableau;
  Array.fill costs n m Rat.zero;
  let t = { n; rows = Array.append tableau [| costs |]; basic = Array.init m (fun r -> n + r) } in
  improve t;
  if Rat.sign (right t.rows.(m)) <> 0 then None
  else begin
    List.iter (drive_out t) (List.init m Fun.id);
    let costs = Array.append cost (Array.make (m + 1) Rat.zero) in
    t.rows.(m) <- costs;
    Array.iteri (fun r j -> if j < n then subtract costs costs.(j) t.rows.(r)) t.basic;
    improve t;
    Some (Rat.neg (right t.rows.(m)))
  end
