type row = (int * Vec.t * Vec.t) list

let speed q row = List.fold_left (fun sum (slot, j, _) -> Rat.add sum (Vec.dot j q.(slot))) Rat.zero row

(* J_k M^-1 J_l^T: what an impulse along the row l changes of J_k q. *)
let product (k : row) (l : row) =
  let rec go sum (k : row) (l : row) =
    match (k, l) with
    | [], _ | _, [] -> sum
    | (i, _, _) :: k', (j, _, _) :: _ when i < j -> go sum k' l
    | (i, _, _) :: _, (j, _, _) :: l' when j < i -> go sum k l'
    | (_, row, _) :: k', (_, _, change) :: l' -> go (Rat.add sum (Vec.dot row change)) k' l'
  in
  go Rat.zero k l

let gram rows =
  let lower = Array.mapi (fun k row -> Array.init (k + 1) (fun l -> product row rows.(l))) rows in
  Array.mapi (fun k _ -> Array.mapi (fun l _ -> if l <= k then lower.(k).(l) else lower.(l).(k)) rows) rows

let two = Rat.of_int 2

(* For y = -q and x its projection on N, which is a cone: y - x is orthogonal to x and has no positive product with
   any element of N. So |q + 2x| = |q| in the kinetic metric, that is the energy is kept; and for each row
   J (q + x) >= 0, hence J (q + 2x) = 2 J (q + x) - J q >= -J q.
   x = 0 iff J q >= 0 for all rows. *)
let reflect q rows =
  let target = Array.map (fun row -> Rat.neg (speed q row)) rows in
  if not (Array.exists (fun t -> Rat.sign t > 0) target) then None
  else begin
    let x = Nnls.solve ~gram:(gram rows) ~target in
    let after = Array.copy q in
    let push size (slot, _, change) = after.(slot) <- Vec.axpy (Rat.mul two size) change after.(slot) in
    Array.iteri (fun k row -> if Rat.sign x.(k) <> 0 then List.iter (push x.(k)) row) rows;
    Some after
  end
