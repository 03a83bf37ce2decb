(* The stores of the explorer against those of the standard library. *)

open Scc_exact
open Scc_graph_search
module Gen = QCheck2.Gen

let pairs =
  let open Gen in
  let number = frequency [ (8, int_range 0 40); (1, int_range 0 0x7fff_ffff) ] in
  QCheck2.Test.make ~count:100 ~name:"Pairs numbers each pair once"
    (list_size (int_range 0 5000) (pair number number))
    (fun list ->
       let p = Pairs.create ~in_files:false and known = Hashtbl.create 100 in
       List.for_all
         (fun (a, b) ->
            let expected =
              match Hashtbl.find_opt known (a, b) with
              | Some i ->
                assert (Pairs.find p a b = i);
                i
              | None ->
                assert (Pairs.find p a b = -1);
                let i = Hashtbl.length known in
                Hashtbl.add known (a, b) i;
                i
            in
            let i = Pairs.intern p a b in
            i = expected && Pairs.left p i = a && Pairs.right p i = b)
         list
       && Pairs.size p = Hashtbl.length known)

(* Tuples come as what differs from one seen before, in any order, and some of it in vain. *)
let tuples =
  let open Gen in
  let case =
    let* width = oneof [ int_range 1 9; int_range 10 40 ] in
    let* list = list_size (int_range 1 300) (array_repeat width (int_range 0 2)) in
    let* near = list_repeat (List.length list) (int_range 0 1000) in
    return (width, List.combine list near)
  in
  QCheck2.Test.make ~count:500 ~name:"Tuples numbers each tuple once, whatever is near" case
    (fun (width, list) ->
       let t = Tuples.create ~width in
       let reader = Tuples.spread t in
       let known = Hashtbl.create 100 and by_number = Hashtbl.create 100 in
       List.for_all
         (fun (tuple, n) ->
            let size = Hashtbl.length known in
            let near = Tuples.spread t in
            let from =
              if size = 0 || n mod 3 = 0 then Array.make width (-1)
              else begin
                Tuples.load t near (n mod size);
                Hashtbl.find by_number (n mod size)
              end
            in
            let needed = Tuples.difference from tuple in
            let all = Tuples.difference (Array.make width (-1)) tuple in
            let changes = if n mod 2 = 0 || width < 2 then needed else all in
            assert (Tuples.apply needed from = tuple);
            let expected = Option.value (Hashtbl.find_opt known tuple) ~default:(-1) in
            assert (Tuples.find t ~near changes = expected);
            let i = Tuples.intern t ~near changes in
            if expected < 0 then begin
              Hashtbl.add known tuple size;
              Hashtbl.add by_number size tuple
            end;
            Tuples.load t reader i;
            let room = Array.make width (-1) in
            Tuples.read_slots reader room;
            i = (if expected < 0 then size else expected) && Tuples.slots reader = tuple && room = tuple)
         list
       && Tuples.size t = Hashtbl.length known)

(* Changes of places, the first of each. *)
let each_once places =
  let keep known (i, v) = if List.mem_assoc i known then known else (i, v) :: known in
  Array.of_list (List.concat_map (fun (i, v) -> [ i; v ]) (List.fold_left keep [] places))

(* With the tuple of zeros. *)
let tuples_of ~width =
  let t = Tuples.create ~width in
  let near = Tuples.spread t in
  ignore (Tuples.intern t ~near (Tuples.difference (Array.make width (-1)) (Array.make width 0)));
  (t, near)

let numbers_together t ~near ~lasting batch =
  Tuples.begin_round t ~near (List.length batch);
  List.iteri (fun n changes -> Tuples.prepare t ~near ~lasting changes n) batch;
  Tuples.fetch t (List.length batch);
  let number n _ = match Tuples.prepared t n with -1 -> Tuples.intern_prepared t n | known -> known in
  List.mapi number batch

(* Few changes at once, in places in any order, many times over: blocks that are remembered, and tuples that come
   up twice among those of one batch. *)
let batches =
  let open Gen in
  let case =
    let* width = int_range 1 30 in
    let change = pair (int_range 0 (width - 1)) (int_range 0 3) in
    let* batches = list_size (int_range 1 100) (list_size (int_range 1 12) (list_size (int_range 0 6) change)) in
    return (width, batches)
  in
  QCheck2.Test.make ~count:300 ~name:"Tuples numbers several at once as one after the other" case
    (fun (width, batches) ->
       let t, near = tuples_of ~width and one_by_one, other = tuples_of ~width in
       List.for_all
         (fun batch ->
            let i = Tuples.size t / 2 in
            Tuples.load t near i;
            Tuples.load one_by_one other i;
            let batch = List.map each_once batch in
            let together = numbers_together t ~near ~lasting:(i land 1 = 0) batch in
            let apart = List.map (Tuples.intern one_by_one ~near:other) batch in
            let right changes id =
              let reader = Tuples.spread t in
              Tuples.load t reader id;
              Tuples.slots reader = Tuples.apply changes (Tuples.slots near)
            in
            together = apart && List.for_all2 right batch together)
         batches)

(* The same arrays of changes near one tuple after the other, some more and some less of them, as transitions of
   states that have halves in common; those of a few places, in one half or in both. *)
let lasting =
  let open Gen in
  let case =
    let* width = int_range 1 12 in
    let change = pair (int_range 0 (width - 1)) (int_range 0 2) in
    let* pool = list_size (int_range 1 10) (list_size (int_range 0 4) change) in
    let* asked = list_size (int_range 1 200) (pair nat (list_size (int_range 0 5) nat)) in
    return (width, pool, asked)
  in
  QCheck2.Test.make ~count:500 ~name:"changes that come again are those that they were" case
    (fun (width, pool, asked) ->
       let t, near = tuples_of ~width and plain, other = tuples_of ~width in
       let pool = List.map each_once pool in
       let left_out_of n m = m mod (2 * List.length pool) = n in
       List.for_all
         (fun (state, left_out) ->
            let i = state mod Tuples.size t in
            Tuples.load t near i;
            Tuples.load plain other i;
            let batch = List.filteri (fun n _ -> not (List.exists (left_out_of n) left_out)) pool in
            numbers_together t ~near ~lasting:true batch = List.map (Tuples.intern plain ~near:other) batch)
         asked)

(* Halves that take each other's places, with changes in any order: what is remembered of one was told of it. *)
let halves =
  let changes = Array.init 40 (fun k -> [| k; k |]) in
  let half = Gen.oneofl [ 0; 1; 64; 65; 128; 8192 ] in
  let asked = Gen.(list_size (1 -- 300) (pair half (list_size (0 -- 40) (0 -- 39)))) in
  let after half k = (100 * half) + k in
  QCheck2.Test.make ~count:300 ~name:"what is remembered of a half was told of it" asked (fun list ->
      let m = Half_memory.create () in
      let ask half k =
        match Half_memory.find m changes.(k) with
        | -1 ->
          Half_memory.keep m changes.(k) (after half k);
          true
        | found -> found = after half k
      in
      List.for_all (fun (half, ks) -> Half_memory.start m half; List.for_all (ask half) ks) list)

let halves_remember () =
  let m = Half_memory.create () and changes = Array.init 3 (fun k -> [| k; k |]) in
  let ask half =
    Half_memory.start m half;
    let one k =
      let found = Half_memory.find m changes.(k) in
      if found < 0 then Half_memory.keep m changes.(k) (half + k);
      found
    in
    List.map one [ 0; 1; 2 ]
  in
  (* A half that comes up once may never come again: it is remembered from the second time on. *)
  Alcotest.(check (list int)) "once" [ -1; -1; -1 ] (ask 5);
  Alcotest.(check (list int)) "twice" [ -1; -1; -1 ] (ask 5);
  Alcotest.(check (list int)) "a third time" [ 5; 6; 7 ] (ask 5);
  Alcotest.(check (list int)) "after another one" [ -1; -1; -1 ] (ask 6);
  Alcotest.(check (list int)) "again" [ 5; 6; 7 ] (ask 5)

(* Against a list, in the order that is asked for. *)
let frontier by_time =
  let open Gen in
  let name = if by_time then "Frontier by time" else "Frontier by steps" in
  let action = oneof [ return None; map Option.some (pair (int_range 0 30) (int_range 0 4)) ] in
  QCheck2.Test.make ~count:2000 ~name (list_size (int_range 0 60) action) (fun actions ->
      let f = if by_time then Frontier.by_time () else Frontier.by_steps () in
      let waiting = ref [] in
      let earlier (_, s) (_, t) = if by_time then Int.compare s t else 0 in
      List.for_all
        (fun action ->
           match action with
           | Some (i, t) ->
             Frontier.push f i (Rat.of_int t);
             waiting := List.stable_sort earlier (!waiting @ [ (i, t) ]);
             Frontier.length f = List.length !waiting
           | None -> (
               match (Frontier.take f, !waiting) with
               | None, [] -> true
               | Some i, (j, _) :: rest ->
                 waiting := rest;
                 i = j
               | None, _ :: _ | Some _, [] -> false))
        actions
      &&
      let left = ref [] in
      Frontier.iter (fun i -> left := i :: !left) f;
      List.rev !left = List.map fst !waiting)

(* Where there are many, some have the same slot and tag as others. *)
let many_pairs () =
  let n = 300_000 and batch = 50 in
  let p = Pairs.create ~in_files:false in
  (* Steps of equal length would be spread too well. *)
  let key i = Pairs.pack (i * i * 7919 land 0x7fff_ffff) i in
  for i = 0 to n - 1 do ignore (Pairs.intern_key p (key i)) done;
  let ids = Array.make batch 0 in
  let wrong = ref 0 in
  for k = 0 to (2 * n / batch) - 1 do
    let keys = Array.init batch (fun i -> key ((k * batch) + i)) in
    Pairs.find_keys p keys ids batch;
    let expected i = if (k * batch) + i < n then (k * batch) + i else -1 in
    Array.iteri (fun i id -> if id <> expected i || Pairs.find_key p keys.(i) <> id then incr wrong) ids
  done;
  Alcotest.(check int) "wrong answers" 0 !wrong

(* Few are taken for known, no more than the bound says, by far; and none that is known is taken for new. *)
let fingerprints () =
  let n = 200_000 in
  let s = Fingerprints.create ~capacity:n in
  let omitted = ref 0 in
  for i = 1 to n do if not (Fingerprints.add s (i * i)) then incr omitted done;
  Alcotest.(check bool) "what is new might have been taken for known" true (Fingerprints.omission s > 1e-5);
  for i = 1 to n do if Fingerprints.add s (i * i) then Alcotest.fail "a member is new" done;
  Alcotest.(check bool) "few" true (!omitted <= 2);
  let p = Fingerprints.omission s in
  Alcotest.(check bool) "a bound" true (p > 0. && p < 1e-2)

let () =
  Alcotest.run "stores"
    [
      ( "random",
        Scc_test_support.Property.cases
          [ pairs; tuples; batches; lasting; halves; frontier false; frontier true ] );
      ( "cases",
        [ Alcotest.test_case "fingerprints" `Quick fingerprints;
          Alcotest.test_case "many pairs" `Quick many_pairs;
          Alcotest.test_case "halves" `Quick halves_remember ] );
    ]
