(* Brownian motion and random walks, for which formulas are known: mean squared displacement, first passage on
   a line and in a square, mean times of return and the stationary distribution of a birth-death chain. All
   are equal, as fractions. *)

open Scc_exact
open Scc_property
open Scc_semantics
open Scc_test_models

let fraction n d = Rat.make (Z.of_int n) (Z.of_int d)
let int = Rat.of_int
let rec power r n = if n = 0 then Rat.one else Rat.mul r (power r (n - 1))
let text = Rat.to_string

(* What all schedulers agree on. *)
let measured model property =
  let e = Load.exactly (Load.text (model ^ "\ncheck asked : " ^ property ^ "\n")) in
  let semantics = Scc_engine.Standard.of_model e.model in
  let initial = Result.get_ok (Network.initial semantics e.declared) in
  match (Scc_verify.Check.run Scc_verify.Setup.default semantics ~initial e.checks).outcomes with
  | [ { verdict = Measured { values = [ (Property.Least, a); (Greatest, b) ]; _ }; _ } ] -> (
      match (a.least, b.most) with
      | Exact x, Exact y when Rat.equal x y -> x
      | _ -> Alcotest.failf "%s is not known\n%s" property model)
  | _ -> Alcotest.failf "%s has no answer\n%s" property model

let is name expected model property =
  Alcotest.(check string) name (text expected) (text (measured model property))

(* {1 Diffusion} *)

let diffusion ~d ~drift:(vx, vy, vz) ~step =
  Printf.sprintf
    "import <solids>\ntimestep %s steady\nprocess p = solids.Cube(1) mass 1 at translate (1, -2, 3) [nil]\n\
     motion p = diffuse(%s, (%s, %s, %s))"
    (text step) (text d) (text vx) (text vy) (text vz)

(* The mean of the squared distance from where it would have drifted is 6 d t, and of the place it is v t; in
   each direction 2 d t. Between two steps, at a time t = n step + s, it has gone on for s with the last
   velocity: 6 d (n step + s^2 / step). *)
let displacement () =
  let try_ ~d ~drift ~step n s =
    let vx, vy, vz = drift and model = diffusion ~d ~drift ~step in
    let t = Rat.add (Rat.mul (int n) step) s in
    let name what = Printf.sprintf "%s, d = %s, step %s, time %s" what (text d) (text step) (text t) in
    let effective = Rat.add (Rat.mul (int n) step) (Rat.div (Rat.mul s s) step) in
    let square v c axis =
      Printf.sprintf "(%s(p) - (%s) - (%s)) * (%s(p) - (%s) - (%s))" axis c (text (Rat.mul v t)) axis c
        (text (Rat.mul v t))
    in
    let x2 = square vx "1" "x" and y2 = square vy "-2" "y" and z2 = square vz "3" "z" in
    let at what = Printf.sprintf "E = ? [ %s at %s ]" what (text t) in
    is (name "in space")
      (Rat.mul (int 6) (Rat.mul d effective))
      model
      (at (Printf.sprintf "%s + %s + %s" x2 y2 z2));
    is (name "along y") (Rat.mul (int 2) (Rat.mul d effective)) model (at y2);
    is (name "the place") (Rat.add Rat.one (Rat.mul vx t)) model (at "x(p)")
  in
  let none = (Rat.zero, Rat.zero, Rat.zero) in
  List.iter
    (fun (d, step) ->
       List.iter (fun n -> try_ ~d ~drift:none ~step n Rat.zero) [ 1; 2; 5 ];
       try_ ~d ~drift:none ~step 3 (Rat.div step (int 3)))
    [ (fraction 1 12, fraction 1 2); (fraction 1 6, Rat.one); (int 2, fraction 1 4);
      (fraction 5 7, fraction 2 3) ];
  try_ ~d:(fraction 1 6) ~drift:(fraction 1 3, fraction (-1) 2, int 2) ~step:Rat.one 3 Rat.zero

(* {1 A line} *)

let line ~p a b =
  Printf.sprintf
    "import <solids>\n\
     process w = solids.Cube(1) mass 1 [nil]\n\
     fixed left = solids.Cube(1) absorb at translate (%d, 0, 0)\n\
     fixed right = solids.Cube(1) absorb at translate (%d, 0, 0)\n\
     motion w = choose { (1, 0, 0) weight %s, (-1, 0, 0) weight 1 - %s }"
    (-a - 1) (b + 1) (text p) (text p)

(* From 0 to a steps to the left or b to the right, with r = q / p. *)
let passage () =
  List.iter
    (fun (p, a, b) ->
       let name what = Printf.sprintf "%s, p = %s, -%d to %d" what (text p) a b in
       let q = Rat.sub Rat.one p in
       let total = a + b in
       let left, time =
         if Rat.equal p q then (fraction b total, int (a * b))
         else
           let r = Rat.div q p in
           let right = Rat.div (Rat.sub Rat.one (power r a)) (Rat.sub Rat.one (power r total)) in
           let gain = Rat.sub (Rat.mul (int total) right) (int a) in
           (Rat.sub Rat.one right, Rat.div gain (Rat.sub p q))
       in
       is (name "to the left") left (line ~p a b) "P = ? [ eventually event absorb(w, left) ]";
       is (name "how long") time (line ~p a b) "E = ? [ time U gone(w) ]")
    [
      (fraction 1 2, 1, 1); (fraction 1 2, 4, 7); (fraction 2 5, 2, 3); (fraction 3 4, 5, 2);
      (fraction 1 100, 3, 6); (fraction 9 10, 1, 12);
    ]

(* {1 A square} *)

(* The solution of a x = b, by elimination. *)
let solve a b =
  let n = Array.length b in
  for i = 0 to n - 1 do
    let pivot = ref i in
    while Rat.sign a.(!pivot).(i) = 0 do incr pivot done;
    let row = a.(i) and right = b.(i) in
    a.(i) <- a.(!pivot);
    a.(!pivot) <- row;
    b.(i) <- b.(!pivot);
    b.(!pivot) <- right;
    for j = 0 to n - 1 do
      if j <> i && Rat.sign a.(j).(i) <> 0 then begin
        let f = Rat.div a.(j).(i) a.(i).(i) in
        for k = i to n - 1 do a.(j).(k) <- Rat.sub a.(j).(k) (Rat.mul f a.(i).(k)) done;
        b.(j) <- Rat.sub b.(j) (Rat.mul f b.(i))
      end
    done
  done;
  Array.init n (fun i -> Rat.div b.(i) a.(i).(i))

(* A walker that goes to each of four neighbours as often, in a square of n by n places, from the place (i,
   j). Beside them it touches a wall. *)
let square n i j =
  let wall name (x, y) (a, b) =
    Printf.sprintf "fixed %s = solids.Cube(1) scaled (%d, %d, 1) absorb at translate (%s, %s, 0)\n" name a b
      (text x) (text y)
  in
  let half = fraction (n - 1) 2 in
  "import <solids>\n"
  ^ Printf.sprintf "process w = solids.Cube(1) mass 1 at translate (%d, %d, 0) [nil]\n" i j
  ^ wall "west" (int (-2), half) (1, n)
  ^ wall "east" (int (n + 1), half) (1, n)
  ^ wall "south" (half, int (-2)) (n, 1)
  ^ wall "north" (half, int (n + 1)) (n, 1)
  ^ "motion w = choose { (1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0) }"

let exit_times n =
  let place i j = (i * n) + j in
  let a = Array.init (n * n) (fun _ -> Array.make (n * n) Rat.zero) in
  for i = 0 to n - 1 do
    for j = 0 to n - 1 do
      let row = a.(place i j) in
      row.(place i j) <- Rat.one;
      List.iter
        (fun (k, l) ->
           if k >= 0 && k < n && l >= 0 && l < n then row.(place k l) <- Rat.sub row.(place k l) (fraction 1 4))
        [ (i + 1, j); (i - 1, j); (i, j + 1); (i, j - 1) ]
    done
  done;
  let times = solve a (Array.make (n * n) Rat.one) in
  fun i j -> times.(place i j)

let in_square () =
  List.iter
    (fun (n, i, j) ->
       let name = Printf.sprintf "%d by %d, from %d %d" n n i j in
       is name (exit_times n i j) (square n i j) "E = ? [ time U gone(w) ]")
    [ (1, 0, 0); (3, 1, 1); (3, 0, 1); (5, 2, 2); (6, 0, 5) ];
  is "3 by 3, from its middle" (fraction 9 2) (square 3 1 1) "E = ? [ time U gone(w) ]"

(* {1 A birth-death chain} *)

(* On the places 0 to 3: up with probability u(k) = (3 - k) / 6, down with d(k) = k / 4, and else it stays. *)
let last = 3
let up k = fraction (last - k) 6
let down k = fraction k 4

let chain start =
  Printf.sprintf
    "import <solids>\nprocess w = solids.Cube(1) mass 1 at translate (%d, 0, 0) [nil]\n\
     motion w = choose { (1, 0, 0) weight (3 - x) / 6, (-1, 0, 0) weight x / 4, \
     (0, 0, 0) weight 1 - (3 - x) / 6 - x / 4 }"
    start

(* By detailed balance: pi (k + 1) d (k + 1) = pi (k) u (k). *)
let stationary () =
  let next k w = if k = last then w else Rat.div (Rat.mul w (up k)) (down (k + 1)) in
  let rec weights k w = if k > last then [] else w :: weights (k + 1) (next k w) in
  let all = weights 0 Rat.one in
  let total = List.fold_left Rat.add Rat.zero all in
  List.map (fun w -> Rat.div w total) all

(* M. Kac: to come back to k takes 1 / pi (k) on the average. *)
let return_times () =
  List.iteri
    (fun k pi ->
       let from j = measured (chain j) (Printf.sprintf "E = ? [ time U x(w) = %d ]" k) in
       let beside p j = if j < 0 || j > last then Rat.zero else Rat.mul p (from j) in
       let mean = Rat.add Rat.one (Rat.add (beside (up k) (k + 1)) (beside (down k) (k - 1))) in
       Alcotest.(check string) (Printf.sprintf "back to %d" k) (text (Rat.div Rat.one pi)) (text mean))
    (stationary ())

(* And after n steps it is as powers of the matrix say. *)
let distribution () =
  let step v =
    Array.init (last + 1) (fun k ->
        let stay = Rat.sub Rat.one (Rat.add (up k) (down k)) in
        let from j p = if j < 0 || j > last then Rat.zero else Rat.mul v.(j) (p j) in
        Rat.add (Rat.mul v.(k) stay) (Rat.add (from (k - 1) up) (from (k + 1) down)))
  in
  let rec go n v =
    for k = 0 to last do
      is (Printf.sprintf "at %d after %d" k n) v.(k) (chain 2)
        (Printf.sprintf "E = ? [ (if x(w) = %d then 1 else 0) at %d ]" k n)
    done;
    if n < 6 then go (n + 1) (step v)
  in
  go 0 (Array.init (last + 1) (fun k -> if k = 2 then Rat.one else Rat.zero))

let () =
  let case name f = Alcotest.test_case name `Quick f in
  Alcotest.run "closed forms"
    [
      ("diffusion", [ case "mean squared displacement" displacement ]);
      ("first passage", [ case "on a line" passage; case "in a square" in_square ]);
      ("a birth-death chain", [ case "times of return" return_times; case "distributions" distribution ]);
    ]
