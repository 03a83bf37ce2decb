open Scc_base

type t = Sqlite3.db

exception Failed of Code.t * string

let fail code format = Printf.ksprintf (fun text -> raise (Failed (code, text))) format
let damaged what = fail Code.damaged_store "the store is damaged: %s" what

(* The database, its log and the folder are open at once, and one more while it is made. *)
let most_open = 4

(* SQLite does not tell that there are too few descriptors: it cannot open a file. *)
let need_descriptors () =
  let rec have opened n =
    if n = 0 then List.iter Unix.close opened
    else
      match Unix.openfile "/dev/null" [ O_RDONLY; O_CLOEXEC ] 0 with
      | fd -> have (fd :: opened) (n - 1)
      | exception Unix.Unix_error (((EMFILE | ENFILE) as error), _, _) ->
        List.iter Unix.close opened;
        raise (Unix.Unix_error (error, "open", "the files of the store"))
      | exception Unix.Unix_error _ -> List.iter Unix.close opened
  in
  have [] most_open

(* What SQLite answers when it should not. *)
let refuse db (rc : Sqlite3.Rc.t) =
  let text = Sqlite3.errmsg db in
  (match rc with CANTOPEN | IOERR -> need_descriptors () | _ -> ());
  match rc with
  | FULL | IOERR -> fail Code.cannot_write "the store cannot be used: %s" text
  | BUSY | LOCKED -> fail Code.no_store "another process has this store"
  | CORRUPT | NOTADB | MISMATCH | CONSTRAINT | FORMAT | SCHEMA | TOOBIG | ERROR -> damaged text
  | NOMEM -> raise Out_of_memory
  | _ -> fail Code.no_store "the store cannot be used: %s" text

let check db (rc : Sqlite3.Rc.t) = match rc with OK | DONE | ROW -> () | _ -> refuse db rc
let run db sql = check db (Sqlite3.exec db sql)

let caught f =
  match f () with
  | x -> Ok x
  | exception Failed (code, text) -> Error (code, text)
  | exception Sqlite3.(Error text | InternalError text | DataTypeError text | SqliteError text) ->
    Error (Code.damaged_store, "the store is damaged: " ^ text)

(* A damaged file may show itself when a statement is made, or at any of its rows. *)
let with_statement db sql values use =
  let statement = try Sqlite3.prepare db sql with Sqlite3.Error _ -> refuse db (Sqlite3.errcode db) in
  Fun.protect
    ~finally:(fun () -> ignore (Sqlite3.finalize statement))
    (fun () ->
       List.iteri (fun i v -> check db (Sqlite3.bind statement (i + 1) v)) values;
       use statement)

let fold db sql values add start =
  with_statement db sql values (fun statement ->
      let rec rows acc =
        match Sqlite3.step statement with
        | ROW -> rows (add acc statement)
        | DONE -> acc
        | rc -> refuse db rc
      in
      rows start)

let change db sql values = with_statement db sql values (fun statement -> check db (Sqlite3.step statement))

let number db sql =
  fold db sql [] (fun _ row -> match Sqlite3.column row 0 with INT n -> Int64.to_int n | _ -> 0) 0

let look_through db =
  run db "PRAGMA cell_size_check = ON";
  let told = fold db "PRAGMA integrity_check(1)" [] (fun _ row -> Sqlite3.column row 0) Sqlite3.Data.NULL in
  match told with
  | TEXT "ok" -> ()
  | TEXT text -> damaged (String.concat ": " (List.filter (( <> ) "") (String.split_on_char '\n' text)))
  | _ -> damaged "it cannot be looked through"

(** {2 Opening} *)

let opened db =
  match db () with
  | db -> db
  | exception Sqlite3.Error text ->
    need_descriptors ();
    fail Code.no_store "the store cannot be opened: %s" text

(* The versions of the format: of wrong ones SQLite tells as of a file that cannot be written to, or is locked. *)
let look_at_header path =
  match open_in_bin path with
  | exception Sys_error _ -> ()
  | file ->
    let head = try really_input_string file 20 with End_of_file | Sys_error _ -> "" in
    close_in_noerr file;
    if String.length head = 20 then
      if not (String.equal (String.sub head 0 16) "SQLite format 3\000") then damaged "file is not a database"
      else if not (head.[18] = head.[19] && (head.[18] = '\001' || head.[18] = '\002')) then
        damaged "its header tells of no format"

let open_to_write path =
  look_at_header path;
  opened (fun () -> Sqlite3.db_open path)

(* SQLite locks a file by these of its bytes. *)
let locked_bytes = (0x40000000, 512)

let is_locked path =
  let at, length = locked_bytes in
  match Unix.openfile path [ O_RDONLY; O_CLOEXEC ] 0 with
  | exception Unix.Unix_error _ -> false
  | fd ->
    Fun.protect
      ~finally:(fun () -> Unix.close fd)
      (fun () ->
         match
           ignore (Unix.lseek fd at SEEK_SET);
           Unix.lockf fd F_TRLOCK length
         with
         | () -> false
         | exception Unix.Unix_error ((EACCES | EAGAIN), _, _) -> true
         | exception Unix.Unix_error _ -> false)

let is_empty path = match Unix.stat path with s -> s.st_size = 0 | exception Unix.Unix_error _ -> true

(* All but letters and figures may have a meaning. *)
let uri path =
  let plain = function 'a' .. 'z' | 'A' .. 'Z' | '0' .. '9' -> true | _ -> false in
  let encoded c = if plain c then String.make 1 c else Printf.sprintf "%%%02X" (Char.code c) in
  "file:" ^ String.concat "" (List.map encoded (List.of_seq (String.to_seq path))) ^ "?immutable=1"

let open_to_read path =
  look_at_header path;
  if is_locked path then fail Code.no_store "another process has this store";
  if not (List.for_all (fun ending -> is_empty (path ^ ending)) [ "-wal"; "-journal" ]) then
    fail Code.no_store
      "the store cannot be written to, and the process that had it last was killed: copy it to where it can be";
  opened (fun () -> Sqlite3.db_open ~mode:`READONLY ~uri:true (uri path))

let close db = ignore (Sqlite3.db_close db)
