(* Lawson and Hanson's active-set method, on the normal equations.

   The passive set P holds the indices whose x may be positive. Three facts make the exact version end
   without any safeguard:
   - when j enters P, its gradient is positive, while the columns in P are orthogonal to the residual; so
     column j is no combination of them, the columns of P stay independent and the system on P has a
     positive definite matrix;
   - then the new solution on P is positive at j, so the step length below is positive;
   - each round ends at the minimum over the span of its P and strictly lowers the objective, so that no
     P occurs twice. *)

(* Solves the positive definite system on the indices [p], by elimination without pivoting. *)
let solve_on gram target p =
  let k = Array.length p in
  let m = Array.map (fun i -> Array.append (Array.map (fun j -> gram.(i).(j)) p) [| target.(i) |]) p in
  for c = 0 to k - 1 do
    let pivot = m.(c).(c) in
    for r = c + 1 to k - 1 do
      if Rat.sign m.(r).(c) <> 0 then begin
        let f = Rat.div m.(r).(c) pivot in
        for j = c to k do
          m.(r).(j) <- Rat.sub m.(r).(j) (Rat.mul f m.(c).(j))
        done
      end
    done
  done;
  let x = Array.make k Rat.zero in
  for r = k - 1 downto 0 do
    let s = ref m.(r).(k) in
    for j = r + 1 to k - 1 do
      s := Rat.sub !s (Rat.mul m.(r).(j) x.(j))
    done;
    x.(r) <- Rat.div !s m.(r).(r)
  done;
  x

let passive_indices passive =
  let keep i = if passive.(i) then Some i else None in
  Array.of_list (List.filter_map keep (List.init (Array.length passive) Fun.id))

(* Moves [x] to the minimum over the span of P, taking out of P what reaches zero on the way. Each round
   but the last takes out at least one index. *)
let rec descend gram target x passive =
  let p = passive_indices passive in
  let s = solve_on gram target p in
  let blocked = ref None in
  Array.iteri
    (fun k i ->
       if Rat.sign s.(k) <= 0 then begin
         let a = Rat.div x.(i) (Rat.sub x.(i) s.(k)) in
         match !blocked with
         | Some b when Rat.compare b a <= 0 -> ()
         | _ -> blocked := Some a
       end)
    p;
  match !blocked with
  | None -> Array.iteri (fun k i -> x.(i) <- s.(k)) p
  | Some a ->
    Array.iteri
      (fun k i ->
         x.(i) <- Rat.add x.(i) (Rat.mul a (Rat.sub s.(k) x.(i)));
         if Rat.sign x.(i) = 0 then passive.(i) <- false)
      p;
    descend gram target x passive

let gradient gram target x i =
  let s = ref target.(i) in
  Array.iteri (fun j g -> if Rat.sign x.(j) <> 0 then s := Rat.sub !s (Rat.mul g x.(j))) gram.(i);
  !s

(* The index outside P of the greatest positive gradient, the first one of equals. *)
let entering gram target x passive =
  let best = ref None in
  for i = 0 to Array.length x - 1 do
    if not passive.(i) then begin
      let g = gradient gram target x i in
      match !best with
      | _ when Rat.sign g <= 0 -> ()
      | Some (_, h) when Rat.compare g h <= 0 -> ()
      | _ -> best := Some (i, g)
    end
  done;
  Option.map fst !best

let solve ~gram ~target =
  let n = Array.length target in
  let x = Array.make n Rat.zero and passive = Array.make n false in
  let rec round () =
    match entering gram target x passive with
    | None -> x
    | Some j ->
      passive.(j) <- true;
      descend gram target x passive;
      round ()
  in
  round ()

let project_cone vectors point =
  let v = Array.of_list vectors in
  let gram = Array.map (fun a -> Array.map (Vec.dot a) v) v in
  let x = solve ~gram ~target:(Array.map (Vec.dot point) v) in
  let sum = ref Vec.zero in
  Array.iteri (fun i a -> if Rat.sign x.(i) <> 0 then sum := Vec.axpy x.(i) a !sum) v;
  !sum

(* Of those that are known, none is farther than the projection is along what is left: so each that is added is
   new. *)
let nearest_in_cone ~most point =
  let rec beside known =
    let x = project_cone known point in
    let rest = Vec.sub point x in
    let next = most rest in
    if Rat.sign (Vec.dot rest next) > 0 then beside (next :: known) else x
  in
  beside []
