(* The structures against those of the standard library, or against what they are by definition. *)

open Scc_data
open Scc_exact
module Gen = QCheck2.Gen

(* {1 Heaps}

   Many times are equal, many differ by less than floats can tell, and some are too great for a float. *)
let time =
  let tiny = Rat.make Z.one (Z.pow (Z.of_int 10) 30) and huge = Rat.make (Z.pow (Z.of_int 10) 400) Z.one in
  let make (whole, fine, scale) =
    let t = Rat.add (Rat.of_int whole) (Rat.mul tiny (Rat.of_int fine)) in
    if scale = 0 then Rat.mul t huge else t
  in
  Gen.map make Gen.(triple (0 -- 3) (0 -- 3) (0 -- 5))

type change = Add of Rat.t | Drop | Keep of int

let change =
  let open Gen in
  frequency [ (6, map (fun t -> Add t) time); (3, pure Drop); (1, map (fun n -> Keep n) (2 -- 5)) ]

let by_time (s, _) (t, _) = Rat.compare s t

let play changes =
  let heap = Heap.create ~near:(fun (t, _) -> Rat.to_float t) ~compare:by_time in
  let step (there, number) = function
    | Add t ->
      Heap.add heap (t, number);
      ((t, number) :: there, number + 1)
    | Drop ->
      let first = Heap.first heap in
      Heap.drop_first heap;
      (match (first, List.sort by_time there) with
       | None, [] -> ([], number)
       | Some (t, item), (least, _) :: _ ->
         if not (Rat.equal t least) then QCheck2.Test.fail_report "not the first one";
         (match List.assoc_opt item (List.map (fun (t, i) -> (i, t)) there) with
          | Some s when Rat.equal s t -> (List.filter (fun (_, i) -> i <> item) there, number)
          | _ -> QCheck2.Test.fail_report "an item at another time")
       | _ -> QCheck2.Test.fail_report "empty or not")
    | Keep n ->
      Heap.keep heap (fun (_, i) -> i mod n > 0);
      (List.filter (fun (_, i) -> i mod n > 0) there, number)
  in
  let there, number = List.fold_left step ([], 0) changes in
  let there, _ = List.fold_left step (there, number) (List.map (fun _ -> Drop) there) in
  there = [] && Heap.size heap = 0

let sorted = QCheck2.Test.make ~name:"the first comes first" ~count:500 Gen.(list_size (0 -- 120) change) play

let sorts =
  QCheck2.Test.make ~count:500 ~name:"taking out sorts" ~print:QCheck2.Print.(list int)
    Gen.(list (int_range 0 50))
    (fun numbers ->
       let h = Heap.create ~near:(fun _ -> 0.) ~compare:Int.compare in
       List.iter (Heap.add h) numbers;
       let rec all acc = match Heap.take h with None -> List.rev acc | Some k -> all (k :: acc) in
       List.equal Int.equal (all []) (List.sort Int.compare numbers))

(* {1 Sets} *)

let bits =
  let changes = Gen.(list (pair bool (int_range 0 1000))) in
  QCheck2.Test.make ~count:300 ~name:"Bits is a set" Gen.(pair (int_range 1 70) changes)
    (fun (n, changes) ->
       let s = Bits.create n and all = Array.make n false in
       List.iter
         (fun (is_in, i) ->
            let i = i mod n in
            all.(i) <- is_in;
            if is_in then Bits.add s i else Bits.remove s i)
         changes;
       let same t = Array.for_all Fun.id (Array.mapi (fun i x -> Bool.equal (Bits.mem t i) x) all) in
       same s && same (Bits.init n (Array.get all)) && Bool.equal (Bits.is_empty s) (not (Array.mem true all)))

let edges =
  let open Gen in
  let node n = int_bound (n - 1) in
  int_range 1 12 >>= fun n -> map (fun l -> (n, l)) (list_size (0 -- 30) (pair (node n) (node n)))

(* Whether ways along the edges lead from one to the other. *)
let closure n edges =
  let way = Array.make_matrix n n false in
  for i = 0 to n - 1 do way.(i).(i) <- true done;
  List.iter (fun (i, j) -> way.(i).(j) <- true) edges;
  for k = 0 to n - 1 do
    for i = 0 to n - 1 do
      for j = 0 to n - 1 do
        if way.(i).(k) && way.(k).(j) then way.(i).(j) <- true
      done
    done
  done;
  way

let pairs n test =
  List.for_all (fun i -> List.for_all (test i) (List.init n Fun.id)) (List.init n Fun.id)

let joined =
  QCheck2.Test.make ~count:500 ~name:"Union_find joins" edges (fun (n, edges) ->
      let sets = Union_find.create n in
      let joins =
        List.for_all
          (fun (i, j) ->
             let apart = Union_find.find sets i <> Union_find.find sets j in
             Bool.equal apart (Union_find.union sets i j))
          edges
      in
      let way = closure n (edges @ List.map (fun (i, j) -> (j, i)) edges) in
      let least i = List.find (fun j -> way.(i).(j)) (List.init n Fun.id) in
      joins && List.for_all (fun i -> Union_find.find sets i = least i) (List.init n Fun.id))

(* {1 Graphs} *)

let successors edges i = List.filter_map (fun (a, b) -> if a = i then Some b else None) edges

let components =
  QCheck2.Test.make ~count:1000 ~name:"strong components" edges (fun (n, edges) ->
      let inside i = i mod 5 <> 4 in
      let c =
        Strong_components.compute ~size:n ~inside ~successors:(fun i -> Array.of_list (successors edges i))
      in
      let way = closure n (List.filter (fun (i, j) -> inside i && inside j) edges) in
      let number = Strong_components.number c and seen = ref [] in
      Strong_components.iter c (fun k v -> seen := (k, v) :: !seen);
      pairs n (fun i j ->
          if inside i && inside j then
            Bool.equal (number i = number j) (way.(i).(j) && way.(j).(i))
            && ((not way.(i).(j)) || number i >= number j)
          else inside i || number i = -1)
      && List.length !seen = List.length (List.filter inside (List.init n Fun.id))
      && List.for_all (fun (k, v) -> number v = k && k < Strong_components.count c) !seen
      && List.map fst !seen = List.rev (List.sort Int.compare (List.map fst !seen)))

let long_way () =
  let n = 1_000_000 in
  let successors i = if i + 1 < n then [| i + 1 |] else [| 0 |] in
  let count successors =
    Strong_components.count (Strong_components.compute ~size:n ~inside:(fun _ -> true) ~successors)
  in
  Alcotest.(check int) "a circle" 1 (count successors);
  Alcotest.(check int) "a chain" n (count (fun i -> if i + 1 < n then [| i + 1 |] else [||]))

let shortest =
  QCheck2.Test.make ~count:500 ~name:"shortest paths" edges (fun (n, edges) ->
      let successors i = List.map (fun j -> (j, (i, j))) (successors edges i) in
      let rec within steps i =
        i = n - 1 || (steps > 0 && List.exists (fun (j, _) -> within (steps - 1) j) (successors i))
      in
      match Shortest_path.find ~successors ~from:0 ~goal:(Int.equal (n - 1)) with
      | None -> not (closure n edges).(0).(n - 1)
      | Some path ->
        let last = List.fold_left (fun at (i, (a, b)) -> if at = i && i = a then b else -1) 0 path in
        last = n - 1 && (path = [] || not (within (Int.min 5 (List.length path - 1)) 0)))

(* {1 Vectors and queues} *)

(* Long runs of equal numbers, across the ends of chunks, and numbers changed afterwards. *)
let vector =
  let open Gen in
  let value = frequency [ (4, int_range (-3) 3); (1, oneofl [ 0x7fff_ffff; -0x8000_0000 ]) ] in
  let runs = list_size (int_range 0 12) (pair (int_range 1 3000) value) in
  let changes = list_size (int_range 0 40) (pair (int_range 0 40_000) value) in
  QCheck2.Test.make ~count:200 ~name:"Int_vector is an array" (pair runs changes) (fun (runs, changes) ->
      let all = Array.concat (List.map (fun (n, x) -> Array.make n x) runs) in
      let v = Int_vector.create () in
      Array.iter (Int_vector.push v) all;
      let n = Array.length all in
      List.iter
        (fun (i, x) ->
           if n > 0 then begin
             Int_vector.set v (i mod n) x;
             all.(i mod n) <- x
           end)
        changes;
      Int_vector.length v = n && Array.for_all Fun.id (Array.mapi (fun i x -> Int_vector.get v i = x) all))

let queue =
  let open Gen in
  QCheck2.Test.make ~count:300 ~name:"Int_queue is a queue"
    (list_size (int_range 0 40) (pair (int_range 0 900) (int_range 0 900)))
    (fun rounds ->
       let q = Int_queue.create () and known = Queue.create () and next = ref 0 in
       List.for_all
         (fun (pushes, takes) ->
            for _ = 1 to pushes do
              incr next;
              Int_queue.push q !next;
              Queue.push !next known
            done;
            List.for_all
              (fun _ -> Int_queue.take q = Queue.take_opt known)
              (List.init takes Fun.id)
            && Int_queue.length q = Queue.length known)
         rounds)

let counts =
  QCheck2.Test.make ~count:300 ~name:"Fenwick counts through all boxes"
    Gen.(pair (int_range 1 70) (list_size (0 -- 60) (pair (int_range 0 1000) (int_range 0 4))))
    (fun (n, changes) ->
       let counts = Fenwick.create n and all = Array.make n 0 in
       List.for_all
         (fun (box, now) ->
            let box = box mod n in
            Fenwick.add counts box (now - all.(box));
            all.(box) <- now;
            let things = List.concat (List.init n (fun box -> List.init all.(box) (fun k -> (box, k)))) in
            Fenwick.total counts = List.length things
            && List.init (Fenwick.total counts) (Fenwick.find counts) = things)
         changes)

(* From each number its double and the next one, below n. *)
let worklist () =
  let n = 1000 in
  let w = Worklist.create n and order = ref [] in
  Worklist.add w 1;
  Worklist.run w (fun i ->
      order := i :: !order;
      List.iter (fun j -> if j < n then Worklist.add w j) [ 2 * i; i + 1 ]);
  Alcotest.(check int) "each once" (n - 1) (List.length (List.sort_uniq Int.compare !order));
  Alcotest.(check (list int)) "first in, first out" [ 1; 2; 4; 3; 8; 5 ]
    (List.filteri (fun i _ -> i < 6) (List.rev !order));
  Alcotest.(check bool) "never added" false (Worklist.mem w 0)

(* Of all lengths about those at which they are put together. *)
let long () =
  let check n =
    let asked = ref [] in
    let word i =
      asked := i :: !asked;
      string_of_int i
    in
    let expected = List.init n string_of_int in
    Alcotest.(check (list string)) "made" expected (Array.to_list (Long_array.init n word));
    Alcotest.(check (list int)) "asked in order" (List.init n Fun.id) (List.rev !asked);
    Alcotest.(check (list string)) "of a list" expected (Array.to_list (Long_array.of_list expected))
  in
  List.iter check [ 0; 1; 2; 255; 256; 257; 511; 512; 513; 1000; 1024 ]

(* An index at the size is refused, whatever the capacity is. *)
let buffers () =
  let b = Int_array.buffer () in
  let refused what f =
    match f () with
    | _ -> Alcotest.failf "%s: not refused" what
    | exception Invalid_argument _ -> ()
  in
  let bounded n =
    Alcotest.(check int) "size" n (Int_array.size b);
    List.iter
      (fun i ->
         refused "nth" (fun () -> Int_array.nth b i);
         refused "put" (fun () -> Int_array.put b i 1; 0))
      [ -1; n; n + 1 ]
  in
  bounded 0;
  refused "pop" (fun () -> Int_array.pop b);
  bounded 0;
  for n = 1 to 40 do
    Int_array.push b n;
    Alcotest.(check int) "the last" n (Int_array.nth b (n - 1));
    bounded n
  done;
  Alcotest.(check int) "popped" 40 (Int_array.pop b);
  bounded 39

(* {1 Caches} *)

module Once_by_int = Once.Make (struct
    include Int

    let hash i = i mod 3
  end)

(* Each is made at the first call for its key, and at no other. *)
let once =
  QCheck2.Test.make ~count:300 ~name:"Once makes a value once" Gen.(list_size (0 -- 60) (0 -- 9)) (fun keys ->
      let made = ref [] in
      let make key =
        made := key :: !made;
        3 * key
      in
      let cache = Once_by_int.create make in
      List.for_all (fun key -> Once_by_int.find cache key = 3 * key) keys
      && List.length !made = List.length (List.sort_uniq Int.compare keys))

type few = Keep of int | Retain_even

(* A list of all entries, cut at its end. *)
let last_few =
  let step = Gen.(oneof [ map (fun i -> Keep i) (0 -- 9); return Retain_even ]) in
  let steps = Gen.(list_size (0 -- 40) step) in
  let name = "Last_few has the last entries" in
  QCheck2.Test.make ~count:300 ~name Gen.(pair (1 -- 5) steps) (fun (most, steps) ->
      let cache = Last_few.create ~most in
      let even (i, _) = i mod 2 = 0 in
      let play (number, entries) = function
        | Keep i ->
          Last_few.keep cache (i, number);
          (number + 1, List.filteri (fun k _ -> k < most) ((i, number) :: entries))
        | Retain_even ->
          Last_few.retain cache even;
          (number, List.filter even entries)
      in
      let _, entries = List.fold_left play (0, []) steps in
      let same i = Last_few.find cache (fun (j, _) -> i = j) = List.find_opt (fun (j, _) -> i = j) entries in
      List.for_all same (List.init 10 Fun.id))

let () =
  Alcotest.run "structures"
    [
      ( "properties",
        Scc_test_support.Property.cases
          [ sorted; sorts; bits; joined; components; shortest; vector; queue; counts; once; last_few ] );
      ( "cases",
        [
          Alcotest.test_case "a million nodes" `Quick long_way;
          Alcotest.test_case "a worklist" `Quick worklist;
          Alcotest.test_case "long arrays" `Quick long;
          Alcotest.test_case "buffers" `Quick buffers;
        ] );
      ("long lists", Long_lists.cases);
    ]
