(* What lib/foundation/base/constant_stack.ml puts in place of the standard library: the same results, calls and
   errors, for lists of any length. *)

module Safe = Scc_base.Constant_stack.List

let lengths = [ 0; 1; 2; 499; 500; 501; 1003 ]
let ints = Alcotest.(list int)

let outcome f = match f () with x -> Ok x | exception Invalid_argument what -> Error what

(* What comes out, and what was asked in which order, unless it is an error: where lists differ in length, versions
   of the standard library differ in what they ask before they fail. *)
let same name n mine standard =
  let run f =
    let asked = ref [] in
    let told x =
      asked := x :: !asked;
      x
    in
    let found = outcome (fun () -> f told) in
    (found, if Result.is_ok found then !asked else [])
  in
  Alcotest.(check (pair (result ints string) ints)) (Printf.sprintf "%s of %d" name n) (run standard) (run mine)

let like_the_standard () =
  let of_length n =
    let l = List.init n (fun i -> (i * 7919) mod 101) in
    let up = List.sort Int.compare l and odd = List.init n (fun i -> (i * 31) mod 17) in
    same "init" n (fun t -> Safe.init n (fun i -> t (i * i))) (fun t -> List.init n (fun i -> t (i * i)));
    same "init of less than nothing" n (fun _ -> Safe.init (-1 - n) Fun.id) (fun _ -> List.init (-1 - n) Fun.id);
    same "map" n (fun t -> Safe.map t l) (fun t -> List.map t l);
    same "mapi" n (fun t -> Safe.mapi (fun i x -> t (i + x)) l) (fun t -> List.mapi (fun i x -> t (i + x)) l);
    same "append" n (fun _ -> Safe.append l up) (fun _ -> List.append l up);
    same "append nothing" n (fun _ -> Safe.append l []) (fun _ -> l);
    same "concat" n (fun _ -> Safe.concat [ l; []; up; l ]) (fun _ -> List.concat [ l; []; up; l ]);
    same "fold_right" n
      (fun t -> Safe.fold_right (fun x found -> t x :: found) l [])
      (fun t -> List.fold_right (fun x found -> t x :: found) l []);
    same "remove_assoc" n
      (fun _ -> Safe.(map snd (remove_assoc 3 (combine odd l))))
      (fun _ -> List.(map snd (remove_assoc 3 (combine odd l))));
    same "merge" n
      (fun _ -> Safe.merge Int.compare up (List.sort Int.compare odd))
      (fun _ -> List.merge Int.compare up (List.sort Int.compare odd));
    let halves split pairs = let a, b = split pairs in a @ b in
    same "split" n
      (fun _ -> halves Safe.split (List.combine l odd))
      (fun _ -> halves List.split (List.combine l odd));
    (* Two of one length, and of two. *)
    let with_other other =
      same "map2" n (fun t -> Safe.map2 (fun x y -> t (x - y)) l other)
        (fun t -> List.map2 (fun x y -> t (x - y)) l other);
      same "combine" n
        (fun _ -> halves List.split (Safe.combine l other))
        (fun _ -> halves List.split (List.combine l other))
    in
    List.iter with_other [ odd; 1 :: odd; [] ];
    same "fold_right2" n
      (fun t -> Safe.fold_right2 (fun x y found -> t (x + y) :: found) l odd [])
      (fun t -> List.fold_right2 (fun x y found -> t (x + y) :: found) l odd [])
  in
  List.iter of_length lengths

let million () =
  let n = 1_000_000 in
  let l = List.init n Fun.id in
  let is name expected found = Alcotest.(check int) name expected (List.length found) in
  is "init" n (Safe.init n Fun.id);
  is "map" n (Safe.map succ l);
  is "mapi" n (Safe.mapi ( + ) l);
  is "map2" n (Safe.map2 ( + ) l l);
  is "append" (2 * n) (Safe.append l l);
  is "concat" n (Safe.concat (Safe.map (fun x -> [ x ]) l));
  is "fold_right" n (Safe.fold_right List.cons l []);
  is "fold_right2" n (Safe.fold_right2 (fun x _ found -> x :: found) l l []);
  is "split" n (fst (Safe.split (Safe.combine l l)));
  is "merge" (2 * n) (Safe.merge Int.compare l l);
  is "remove_assoc" (n - 1) (Safe.remove_assoc (n - 1) (Safe.combine l l))

let cases =
  [
    Alcotest.test_case "as in the standard library" `Quick like_the_standard;
    Alcotest.test_case "of a million" `Quick million;
  ]
