(* Tables that several processes write at once, against one of this process alone. *)

open Scc_shared
open Scc_graph_search

let processes = 8

(* With an argument, so many insertions of all processes together, timed against one process. *)
let operations = 1 lsl 20

let get = function Some x -> x | None -> Alcotest.fail "the system gives no memory that processes share"

(* The same few pairs, in an order that is another one in each process. *)
let pairs = 1 lsl 16

let key who k =
  let k = ((k * 0x9E3779B1) lxor (who * 0x85EBCA6B)) land max_int mod pairs in
  Pairs.pack (k / 300) (k mod 300)

let shared ~bits =
  let p = Pairs.create ~in_files:false in
  Alcotest.(check bool) "shared" true (Pairs.share p ~many:true);
  for _ = 1 to bits do Pairs.enlarge_shared p done;
  p

let in_process work =
  match Unix.fork () with
  | 0 -> (match work () with () -> Unix._exit 0 | exception _ -> Unix._exit 1)
  | pid -> pid

let ended pid =
  match Unix.waitpid [] pid with
  | _, WEXITED 0 -> ()
  | _ -> Alcotest.fail "a process did not come to its end"

(* Each process notes the numbers that it got: of all of a key there is one, and it is that of the key alone. *)
let insert p (numbers : Shared_memory.numbers) count who () =
  Pairs.go_on_apart p ~full:(fun () -> failwith "full");
  for k = 0 to count - 1 do
    let key = key who k in
    let number = Pairs.intern_key p key in
    if Pairs.key p number <> key then failwith "another key";
    let at = (Pairs.unpack_left key * 300) + Pairs.unpack_right key in
    match Shared_memory.swap numbers at (1 + number) with
    | 0 -> ()
    | known -> if known <> 1 + number then failwith "two numbers"
  done

let all_at_once p numbers count =
  List.iter ended (List.init processes (fun who -> in_process (insert p numbers (count / processes) who)))

let is_whole p numbers =
  let given = Hashtbl.create pairs in
  for k = 0 to pairs - 1 do
    let number = Pairs.find p (k / 300) (k mod 300) in
    let noted = Bigarray.Array1.get numbers k - 1 in
    if number <> noted then Alcotest.failf "pair %d has the number %d, and was told %d" k number noted;
    if number >= 0 then begin
      if Hashtbl.mem given number then Alcotest.failf "two pairs have the number %d" number;
      Hashtbl.replace given number ()
    end
  done;
  Alcotest.(check bool) "many" true (Hashtbl.length given > pairs / 2)

(* The second time, processes are forked from one that has inserted pairs itself, and goes on meanwhile. *)
let one_table () =
  let p = shared ~bits:4 and numbers = get (Shared_memory.numbers (pairs + 300)) in
  all_at_once p numbers (operations / 2);
  is_whole p numbers;
  let mine = Pairs.intern p 1000 1000 in
  let others = List.init processes (fun who -> in_process (insert p numbers (operations / 16) (who + 100))) in
  for k = 0 to 99 do ignore (Pairs.intern p 2000 k) done;
  List.iter ended others;
  is_whole p numbers;
  Alcotest.(check int) "what was there" mine (Pairs.find p 1000 1000);
  for k = 0 to 99 do
    let number = Pairs.find p 2000 k in
    Alcotest.(check (pair int int)) "its own" (2000, k) (Pairs.left p number, Pairs.right p number)
  done;
  (* A larger index, and then a table of this process alone, have the same. *)
  Pairs.enlarge_shared p;
  is_whole p numbers;
  Pairs.unshare p;
  is_whole p numbers;
  Alcotest.(check bool) "a new one" true (Pairs.intern p 3000 3000 >= pairs / 2)

(* Killed wherever they are, processes leave a table that others go on with. *)
let killed () =
  let p = shared ~bits:4 and numbers = get (Shared_memory.numbers (pairs + 300)) in
  for round = 1 to 40 do
    let one who = in_process (fun () -> insert p numbers max_int (who + round) ()) in
    let some = List.init 3 one in
    Unix.sleepf 0.002;
    let kill pid =
      Unix.kill pid Sys.sigkill;
      ignore (Unix.waitpid [] pid)
    in
    List.iter kill some
  done;
  (* A number that was given may not have been noted. *)
  all_at_once p numbers operations;
  is_whole p numbers

(* Of texts: equal ones have equal numbers in all processes, whoever comes first, and are read back. *)
let texts () =
  let table = get (Common.create ~first:10) and found = get (Shared_memory.numbers 2000) in
  let text k = String.make (k mod 7) '\000' ^ string_of_int k ^ String.make (k mod 3) '\255' in
  let look who () =
    let n = Common.numbers () in
    Common.share n table ~kind:3 ~base:10;
    Common.go_on_apart table ~full:(fun () -> failwith "full");
    for own = 10 to 1999 do
      let k = if who land 1 = 0 then own else 2009 - own in
      let number = Common.common n own (fun _ -> text k) in
      match Shared_memory.swap found k number with
      | 0 -> ()
      | known -> if known <> number then failwith "two numbers"
    done
  in
  List.iter ended (List.init processes (fun who -> in_process (look who)));
  let n = Common.numbers () in
  Common.share n table ~kind:3 ~base:10;
  for k = 10 to 1999 do
    let read = ref "" in
    let make text =
      read := text;
      k
    in
    ignore (Common.own n found.{k} make);
    Alcotest.(check string) "the text" (text k) !read
  done

(* What is noted of a state, the least and the greatest, and nothing before; what was told of an edge from it. *)
let states () =
  let s = get (Shared_states.create ()) in
  let most = (1 lsl 31) - 1 in
  let look i (depth, arrival) =
    Alcotest.(check bool) "nothing as yet" true (Shared_states.is_nothing (Shared_states.noted s i));
    Shared_states.put s i ~depth ~arrival;
    let noted = Shared_states.noted s i in
    Alcotest.(check bool) "something" false (Shared_states.is_nothing noted);
    let read = (Shared_states.depth_of noted, Shared_states.arrival_of noted) in
    Alcotest.(check (pair int int)) "it" (depth, arrival) read;
    let key = 1000 + i in
    let has_told () = Shared_states.has_told s key ~from:i ~way:(-1) in
    Alcotest.(check (pair int bool)) "not told" (-1, false) (Shared_states.flags s key, has_told ());
    Shared_states.tell s key 5 ~from:i ~way:(-1) ~told:false;
    Alcotest.(check (pair int bool)) "not to be relied on" (5, false) (Shared_states.flags s key, has_told ());
    Shared_states.tell s key 6 ~from:i ~way:(-1) ~told:true;
    Alcotest.(check (pair int bool)) "told" (6, true) (Shared_states.flags s key, has_told ());
    Alcotest.(check bool) "another way" false (Shared_states.has_told s key ~from:i ~way:7);
    Shared_states.improved s;
    Alcotest.(check bool) "something has improved" false (has_told ())
  in
  List.iteri look [ (0, 0); (0, 1); (1, 0); (most, 0); (0, most); (most, most) ]

let timed what work =
  let start = Unix.gettimeofday () and before = Unix.times () in
  work ();
  let after = Unix.times () in
  let worked = after.tms_cutime +. after.tms_cstime -. before.tms_cutime -. before.tms_cstime in
  Printf.printf "%s: %.2f s, %.2f s of processors\n%!" what (Unix.gettimeofday () -. start) worked

let compare_speeds count =
  let run processes_ =
    let p = shared ~bits:4 and numbers = get (Shared_memory.numbers (pairs + 300)) in
    let one who = in_process (insert p numbers (count / processes_) who) in
    timed
      (Printf.sprintf "%d insertions by %d" count processes_)
      (fun () -> List.iter ended (List.init processes_ one));
    is_whole p numbers
  in
  run 1;
  run processes

let () =
  match Sys.argv with
  | [| _; "--operations"; count |] -> compare_speeds (int_of_string count)
  | _ ->
    Alcotest.run "shared"
      [
        ( "tables",
          [
            Alcotest.test_case "of pairs" `Quick one_table;
            Alcotest.test_case "after processes were killed" `Quick killed;
            Alcotest.test_case "of texts" `Quick texts;
            Alcotest.test_case "of states" `Quick states;
          ] );
      ]
