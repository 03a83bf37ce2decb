(* Systems solved by lifting: whether the rows hold; and what is given up. *)

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

let lift ?(bits = 20_000) ?(steps = 1 lsl 30) ?(interrupted = never) ~size row constant =
  Lifting.solve ~size ~row ~constant ~bits ~steps ~interrupted

let lifted ?bits ?steps ?interrupted m =
  lift ?bits ?steps ?interrupted ~size:(Array.length m.rows) (matrix_row m) (Array.get m.constants)

let holds ~size row constant ({ numerators; denominator; _ } : Lifting.solution) =
  let x = Array.map (fun n -> Rat.make n denominator) numerators in
  let row_holds i =
    let sum = List.fold_left (fun sum (j, a) -> Rat.add sum (Rat.mul a x.(j))) Rat.zero (row i) in
    Rat.equal sum (constant i)
  in
  Array.for_all Fun.id (Array.init size row_holds)

let solves m =
  match lifted m with
  | Error _ -> QCheck2.Test.fail_report "nothing is found"
  | Ok x -> holds ~size:(Array.length m.rows) (matrix_row m) (Array.get m.constants) x

(* Entries and constants of some hundred bits, where all others are short; also 0 modulo the first prime. *)
let solves_long (m, bits) =
  let size = Array.length m.rows in
  let prime = Z.of_int (Factors.prime_below (1 lsl 28)) in
  let long = Rat.make (Z.pow prime 5) (Z.add Z.one (Z.shift_left Z.one bits)) in
  let row i =
    if i mod 3 > 0 then matrix_row m i
    else
      let longer (j, a) = (j, if j = i then Rat.add (Rat.of_int 2) (Rat.mul long (Rat.add a (rat 2 7))) else a) in
      List.map longer (matrix_row m i)
  in
  let constant i = if i mod 2 = 0 then Rat.mul long m.constants.(i) else m.constants.(i) in
  match lift ~size row constant with
  | Error _ -> QCheck2.Test.fail_report "nothing is found"
  | Ok x -> holds ~size row constant x

(* Each unknown asks for many others: elimination leaves them to lifting. *)
let dense n =
  let weight i j = 1 + (((i * i * j) + (j * j * j) + i) mod 11) in
  let row i = List.filter (fun (j, _) -> j <> i) (List.init n (fun j -> (j, weight i j))) in
  {
    rows = Array.init n row; leaves = Array.init n (fun i -> 2 + (i mod 5));
    constants = Array.init n (fun i -> rat (i mod 3) 2);
  }

let why_not = function
  | Ok (_ : Lifting.solution) -> "found"
  | Error Lifting.Interrupted -> "interrupted"
  | Error Too_long -> "too long"
  | Error Too_much -> "too much"

let too_long () =
  Alcotest.(check string) "limit of bits" "too long" (why_not (lifted ~bits:40 (dense 60)))

let stops () =
  Alcotest.(check string) "interrupted" "interrupted" (why_not (lifted ~interrupted:(fun () -> true) (dense 30)));
  Alcotest.(check string) "a limit of steps" "too much" (why_not (lifted ~steps:1_000 (dense 30)));
  Alcotest.(check string) "in the digits" "too much" (why_not (lifted ~steps:60_000 (dense 30)))

(* A diagonal entry that the first prime divides: the next one serves. *)
let unlucky () =
  let p = Factors.prime_below (1 lsl 28) in
  let row i = [ (0, Rat.of_int (if i = 0 then p else 1)); (1, Rat.of_int (2 + i)) ] in
  match lift ~size:2 row (fun _ -> Rat.one) with
  | Ok x -> Alcotest.(check bool) "solved" true (holds ~size:2 row (fun _ -> Rat.one) x)
  | Error _ as e -> Alcotest.fail (why_not e)

(* The order has each unknown once, and the fill of a tree is none: a star of long arms, numbered anyhow. *)
let orders () =
  let n = 4_000 in
  let number i = i * 1_201 mod n in
  let neighbours = Array.make n [||] in
  for i = 0 to n - 1 do
    let near = if i = 0 then List.init 8 (fun a -> a + 1) else [ (if i <= 8 then 0 else i - 8) ] in
    let far = if i > 0 && i + 8 < n then [ i + 8 ] else [] in
    neighbours.(number i) <- Array.of_list (List.sort Int.compare (List.map number (near @ far)))
  done;
  match Fill_order.compute ~neighbours ~most:(1 lsl 22) ~interrupted:never with
  | None -> Alcotest.fail "too many steps"
  | Some { order; _ } ->
    Alcotest.(check (list int)) "each once" (List.init n Fun.id) (List.sort Int.compare (Array.to_list order));
    let place = Array.make n 0 in
    Array.iteri (fun k i -> place.(i) <- k) order;
    let later i = Array.fold_left (fun c j -> if place.(j) > place.(i) then c + 1 else c) 0 neighbours.(i) in
    for i = 0 to n - 1 do
      Alcotest.(check bool) "one after it" true (later i <= 1)
    done

let () =
  let case name f = Alcotest.test_case name `Quick f in
  let law name gen f = QCheck2.Test.make ~name ~count:200 gen f in
  Alcotest.run "lifting"
    [
      ( "random",
        Scc_test_support.Property.cases [
          law "the rows hold" matrix solves;
          law "long numbers" (Gen.pair matrix (Gen.int_range 30 300)) solves_long;
        ] );
      ( "by hand",
        [
          case "long numbers" too_long; case "interrupted" stops; case "an unlucky prime" unlucky;
          case "an order" orders;
        ] );
    ]
