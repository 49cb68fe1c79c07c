//! A disk that is full, and a class that is.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by them")]

use super::super::{ClassRow, Fault, NewEvent, NewSeat};
use super::Sqlite;

fn event(seq: u64) -> NewEvent {
    NewEvent { seq, kind: "part", body: "x".repeat(2000) }
}

async fn store_with_classes(folder: &tempfile::TempDir) -> Sqlite {
    let store = Sqlite::open(&folder.path().join("class.sqlite")).unwrap();
    for class in ["c", "d"] {
        let class = ClassRow {
            class: class.to_owned(),
            code: class.to_owned(),
            title: String::new(),
            survey: String::new(),
            created: 0,
            expires: 1,
        };
        store.add_class(class, false).await.unwrap();
    }
    store
}

#[tokio::test]
async fn a_class_takes_so_many_answers_to_surveys_and_says_when_it_is_full() {
    let folder = tempfile::tempdir().unwrap();
    let store = store_with_classes(&folder).await;
    let numbers = "WITH RECURSIVE number(n) AS (SELECT 1 UNION ALL SELECT n+1 FROM number WHERE n<9999)
        INSERT INTO sheet SELECT 'c', CAST(printf('%016d', n) AS BLOB), '{}' FROM number";
    store.alone(move |connection| Ok(connection.execute(numbers, []).map(drop)?)).await.unwrap();
    let add = |class: &str, id: u8| store.add_sheet(class.to_owned(), [id; 16], "{}".to_owned());
    add("c", 1).await.unwrap();
    assert!(matches!(add("c", 2).await, Err(Fault::SheetsFull)));
    // Sent again because the reply was lost; and another class has room.
    add("c", 1).await.unwrap();
    add("d", 2).await.unwrap();
    assert_eq!(store.sheets("c".to_owned()).await.unwrap().len(), 10_000);
}

#[tokio::test]
async fn a_full_disk_loses_nothing_and_the_store_goes_on_when_there_is_room() {
    let folder = tempfile::tempdir().unwrap();
    let store = store_with_classes(&folder).await;
    let seat = NewSeat { pseudonym: "a".to_owned(), key: [0; 32], approved: true };
    store.add_seat("c".to_owned(), seat, [1; 32], 9).await.unwrap();
    // SQLite answers with the same error as on a full disk.
    let limit = |pages: i64| {
        store.alone(move |connection| {
            connection.query_row(&format!("PRAGMA max_page_count={pages}"), [], |row| row.get::<_, i64>(0))?;
            Ok(())
        })
    };
    limit(60).await.unwrap();
    let mut acknowledged = Vec::new();
    let mut refused = Vec::new();
    for group in 0..10 {
        let sends = (1..=20).map(|place| {
            let seq = 20 * group + place;
            let store = store.clone();
            tokio::spawn(async move { (seq, store.append("c".to_owned(), 1, 0, vec![event(seq)]).await) })
        });
        for send in sends.collect::<Vec<_>>() {
            match send.await.unwrap() {
                (seq, Ok(_)) => acknowledged.push(seq),
                (seq, Err(Fault::Unwritable(_))) => refused.push(seq),
                (_, Err(other)) => panic!("{other}"),
            }
        }
    }
    assert!(!acknowledged.is_empty() && !refused.is_empty());
    let stored = |store: &Sqlite| {
        let store = store.clone();
        async move {
            store.events_of_seat("c".to_owned(), 1).await.unwrap().iter().map(|event| event.seq).collect::<Vec<_>>()
        }
    };
    let present = stored(&store).await;
    assert!(acknowledged.iter().all(|seq| present.contains(seq)));
    limit(1_000_000).await.unwrap();
    for seq in refused {
        store.append("c".to_owned(), 1, 0, vec![event(seq)]).await.unwrap();
    }
    assert_eq!(stored(&store).await, (1..=200).collect::<Vec<_>>());
    let whole: String = store
        .read(|connection| Ok(connection.query_row("PRAGMA integrity_check", [], |row| row.get(0))?))
        .await
        .unwrap();
    assert_eq!(whole, "ok");
}
