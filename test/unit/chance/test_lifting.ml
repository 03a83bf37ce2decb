(* Systems solved by lifting, against elimination in rationals; and what is refused. *)

open Scc_exact
open Scc_chance
module Gen = QCheck2.Gen

let rat n d = Rat.make (Z.of_int n) (Z.of_int d)
let never () = false

(* Rows of I - P: weights of some columns, of which a share leaves. *)
type matrix = { rows : (int * int) list array; leaves : int array; constants : Rat.t array }

let matrix =
  let open Gen in
  let* n = 1 -- 30 in
  let* density = 1 -- 6 in
  let row i =
    let* others = list_size (0 -- density) (pair (int_bound (n - 1)) (1 -- 9)) in
    let+ leaves = 1 -- 3 in
    let once = List.sort_uniq (fun (j, _) (k, _) -> Int.compare j k) others in
    (List.filter (fun (j, _) -> j <> i || n = 1) once, leaves)
  in
  let* rows = flatten_l (List.init n row) in
  let+ constants = list_repeat n (map2 rat (-9 -- 9) (1 -- 12)) in
  {
    rows = Array.of_list (List.map fst rows); leaves = Array.of_list (List.map snd rows);
    constants = Array.of_list constants;
  }

let total m i = List.fold_left (fun sum (_, w) -> sum + w) m.leaves.(i) m.rows.(i)
let chances m i = List.map (fun (j, w) -> (j, rat w (total m i))) m.rows.(i)

let matrix_row m i =
  let own, others = List.partition (fun (j, _) -> j = i) (chances m i) in
  let diagonal = List.fold_left (fun d (_, p) -> Rat.sub d p) Rat.one own in
  (i, diagonal) :: List.map (fun (j, p) -> (j, Rat.neg p)) others

let lifted ?(bits = 20_000) ?(interrupted = never) m =
  let constant = Array.get m.constants in
  Lifting.solve ~size:(Array.length m.rows) ~row:(matrix_row m) ~constant ~bits ~interrupted

let solves m =
  match lifted m with
  | Error _ -> QCheck2.Test.fail_report "nothing is found"
  | Ok x ->
    let holds i =
      let sum = List.fold_left (fun sum (j, a) -> Rat.add sum (Rat.mul a x.(j))) Rat.zero (matrix_row m i) in
      Rat.equal sum m.constants.(i)
    in
    Array.for_all Fun.id (Array.init (Array.length x) holds)

let as_elimination m =
  let size = Array.length m.rows and constant = Array.get m.constants in
  match (lifted m, Elimination.solve ~size ~row:(chances m) ~constant ~bits:20_000 ~interrupted:never) with
  | Ok x, Ok y -> Array.for_all Fun.id (Array.map2 Rat.equal x y)
  | (Ok _ | Error _), _ -> false

(* Each unknown asks for many others: elimination leaves them to lifting. *)
let dense n =
  let row i = List.filter (fun (j, _) -> j <> i) (List.init n (fun j -> (j, 1 + (((i * i * j) + i) mod 7)))) in
  {
    rows = Array.init n row; leaves = Array.make n 2;
    constants = Array.init n (fun i -> rat (i mod 3) 2);
  }

let too_long () =
  let why =
    match lifted ~bits:40 (dense 30) with
    | Ok _ -> "found"
    | Error Too_long -> "too long"
    | Error _ -> "other"
  in
  Alcotest.(check string) "limit of bits" "too long" why

let stops () =
  let why =
    match lifted ~interrupted:(fun () -> true) (dense 30) with
    | Error Interrupted -> "interrupted"
    | Ok _ | Error _ -> "went on"
  in
  Alcotest.(check string) "interrupted" "interrupted" why

let one_row row constant =
  Lifting.solve ~size:1 ~row:(fun _ -> row) ~constant:(fun _ -> constant) ~bits:1000 ~interrupted:never

let unfit () =
  let is_unfit = function Error Lifting.Unfit -> true | Ok _ | Error _ -> false in
  let long = Rat.make Z.one (Z.shift_left Z.one 40) in
  Alcotest.(check bool) "long entries" true (is_unfit (one_row [ (0, Rat.add Rat.one long) ] Rat.one));
  Alcotest.(check bool) "no inverse" true (is_unfit (one_row [] Rat.one))

let elimination_of_many () =
  let m = dense 90 in
  match
    Elimination.solve ~size:90 ~row:(chances m) ~constant:(Array.get m.constants) ~bits:20_000 ~interrupted:never
  with
  | Error _ -> Alcotest.fail "nothing is found"
  | Ok x ->
    let equal = Array.map2 Rat.equal x (Result.get_ok (lifted m)) in
    Alcotest.(check bool) "as lifted" true (Array.for_all Fun.id equal)

let () =
  let case name f = Alcotest.test_case name `Quick f in
  let law name f = QCheck2.Test.make ~name ~count:200 matrix f in
  Alcotest.run "lifting"
    [
      ( "random",
        Scc_test_support.Property.cases [ law "the rows hold" solves; law "as by elimination" as_elimination ] );
      ( "by hand",
        [
          case "long numbers" too_long; case "interrupted" stops; case "what does not fit" unfit;
          case "many unknowns" elimination_of_many;
        ] );
    ]
