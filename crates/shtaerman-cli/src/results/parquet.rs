//! Parts as Parquet files: one row group, no value missing (NaN where there is none).

#[cfg(feature = "parquet")]
pub(super) use files::{columns, content, is_of_pyarrow};

#[cfg(not(feature = "parquet"))]
pub(super) use nothing::{columns, content, is_of_pyarrow};

/// Programs without the format; [`check`](crate::arguments::PartFormat::check) has said so before.
#[cfg(not(feature = "parquet"))]
mod nothing {
    use shtaerman_study::{Column, Row, Study};

    use crate::Failure;
    use crate::output::Content;

    pub(in crate::results) fn content<'r>(_: &Study, _: &[Row]) -> Result<Content<'r>, Failure> {
        Err(Failure::Usage("this program was built without Parquet".to_owned()))
    }

    pub(in crate::results) fn columns(_: &Study, _: &[u8]) -> Option<Vec<Column>> {
        None
    }

    pub(in crate::results) fn is_of_pyarrow(_: &[u8]) -> bool {
        false
    }
}

#[cfg(feature = "parquet")]
mod files {
    use std::path::Path;
    use std::sync::Arc;

    use bytes::Bytes;
    use parquet::basic::{LogicalType, Repetition, Type as Physical};
    use parquet::column::reader::get_typed_column_reader;
    use parquet::data_type::{ByteArray, ByteArrayType, DataType, DoubleType, Int64Type};
    use parquet::errors::ParquetError;
    use parquet::file::properties::WriterProperties;
    use parquet::file::reader::{FileReader, RowGroupReader, SerializedFileReader};
    use parquet::file::writer::SerializedFileWriter;
    use parquet::schema::types::Type;
    use shtaerman_study::{Column, Row, Study};

    use crate::Failure;
    use crate::output::Content;

    /// The file of these rows.
    pub(in crate::results) fn content<'r>(
        study: &Study,
        rows: &[Row],
    ) -> Result<Content<'r>, Failure> {
        let failed = |error: ParquetError| {
            Failure::unwritten(Path::new("memory"), &std::io::Error::other(error))
        };
        written(&study.columns(), &study.arrays(rows)).map(Content::from).map_err(failed)
    }

    fn written(names: &[String], columns: &[Column]) -> Result<Vec<u8>, ParquetError> {
        let fields = names.iter().zip(columns).map(|(name, column)| {
            let physical = match column {
                Column::Whole(_) => Physical::INT64,
                Column::Number(_) => Physical::DOUBLE,
                Column::Text(_) => Physical::BYTE_ARRAY,
            };
            let logical = matches!(column, Column::Text(_)).then_some(LogicalType::String);
            Type::primitive_type_builder(name, physical)
                .with_repetition(Repetition::REQUIRED)
                .with_logical_type(logical)
                .build()
                .map(Arc::new)
        });
        let fields = fields.collect::<Result<Vec<_>, _>>()?;
        let schema = Arc::new(Type::group_type_builder("study").with_fields(fields).build()?);
        let mut bytes = Vec::new();
        let properties = Arc::new(WriterProperties::builder().build());
        let mut writer = SerializedFileWriter::new(&mut bytes, schema, properties)?;
        let mut group = writer.next_row_group()?;
        for column in columns {
            let Some(mut place) = group.next_column()? else { break };
            match column {
                Column::Whole(values) => {
                    place.typed::<Int64Type>().write_batch(values, None, None)?
                }
                Column::Number(values) => {
                    place.typed::<DoubleType>().write_batch(values, None, None)?
                }
                Column::Text(values) => {
                    let values: Vec<ByteArray> =
                        values.iter().map(|text| ByteArray::from(text.as_str())).collect();
                    place.typed::<ByteArrayType>().write_batch(&values, None, None)?
                }
            };
            place.close()?;
        }
        group.close()?;
        writer.close()?;
        Ok(bytes)
    }

    /// The columns of a whole file of this study.
    pub(in crate::results) fn columns(study: &Study, bytes: &[u8]) -> Option<Vec<Column>> {
        let reader = SerializedFileReader::new(Bytes::copy_from_slice(bytes)).ok()?;
        let schema = reader.metadata().file_metadata().schema_descr_ptr();
        let names = schema.columns().iter().map(|column| column.name().to_owned());
        if reader.num_row_groups() != 1 || !names.eq(study.columns()) {
            return None;
        }
        let group = reader.get_row_group(0).ok()?;
        let kinds = schema.columns().iter().map(|column| column.physical_type());
        kinds.enumerate().map(|(place, kind)| column(group.as_ref(), place, kind)).collect()
    }

    /// Whether a file was written by the Python package, whose pyarrow has other bytes for the same columns.
    pub(in crate::results) fn is_of_pyarrow(bytes: &[u8]) -> bool {
        let reader = SerializedFileReader::new(Bytes::copy_from_slice(bytes));
        reader.is_ok_and(|reader| {
            let by = reader.metadata().file_metadata().created_by();
            by.is_some_and(|by| by.starts_with("parquet-cpp-arrow"))
        })
    }

    fn column(group: &dyn RowGroupReader, place: usize, kind: Physical) -> Option<Column> {
        match kind {
            Physical::INT64 => values::<Int64Type>(group, place).map(Column::Whole),
            Physical::DOUBLE => values::<DoubleType>(group, place).map(Column::Number),
            Physical::BYTE_ARRAY => {
                let texts = values::<ByteArrayType>(group, place)?;
                let texts = texts.iter().map(|text| Some(text.as_utf8().ok()?.to_owned()));
                texts.collect::<Option<_>>().map(Column::Text)
            }
            _ => None,
        }
    }

    fn values<T: DataType>(group: &dyn RowGroupReader, place: usize) -> Option<Vec<T::T>> {
        let count = usize::try_from(group.metadata().num_rows()).ok()?;
        let mut reader = get_typed_column_reader::<T>(group.get_column_reader(place).ok()?);
        let mut values = Vec::new();
        let (_, read, _) = reader.read_records(count, None, None, &mut values).ok()?;
        (read == count).then_some(values)
    }
}
